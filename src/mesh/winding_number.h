#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// The generalised winding number of a mesh (Jacobson et al. 2013): the solid angle in which a
/// point sees the triangles' inner sides, less that of their outer sides, over 4π. For a closed
/// mesh it is how many times the surface goes round the point; with holes it changes smoothly
/// across them, by the part of the sphere of directions that they take.
///
/// Triangles far from the point count in groups, by the first three terms of the group's expansion
/// (Barill et al. 2018, "Fast Winding Numbers for Soups and Clouds"); near ones exactly, by van
/// Oosterom and Strackee's formula.
class WindingNumber {
 public:
  explicit WindingNumber(const TriangleMesh& mesh);

  /// Within 0.01 of the exact value in practice. Safe to call from several threads.
  float operator()(const glm::vec3& point) const;

 private:
  struct Triangle {
    glm::vec3 a, b, c;
  };
  /// A group of triangles: the leaf's own or all of those below.
  struct Node {
    glm::vec3 center{0};   ///< mean of the triangles' centres by area
    float squaredFar = 0;  ///< from this squared distance on, the group counts as a whole
    glm::vec3 vectorArea{0};
    /// Symmetric parts of the moments of the vector area n about the centre. Of ∫ n dᵀ: xx, yy, zz
    /// and yz, zx, xy. Of ∫ n d d: xxx, yyy, zzz; xxy, yyz, zzx; xxz, yyx, zzy; xyz.
    glm::vec3 squares{0}, products{0};
    glm::vec3 cubes{0}, squaresByNext{0}, squaresByLast{0};
    float product = 0;
    std::uint32_t begin = 0, end = 0;  ///< triangles
    std::uint32_t next = 0;            ///< the first node that is not below this one
    bool leaf = false;
  };
  struct Builder;

  float groupAngle(const Node& node, const glm::vec3& toCenter, float squaredDistance) const;

  glm::dvec3 origin_{0};
  double scale_ = 1;  ///< the tree holds (position − origin) · scale, at most 1 in size
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;  ///< each followed by those below it
};

}  // namespace haarlight
