#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// The faces that meet at a vertex, as what is infinitely near sees them: as endless sectors. They
/// decide what rays against the mesh cannot, for these start on those faces: whether a ray over the
/// hemisphere of the vertex's normal leaves on the lit side, or goes through the faces. It does
/// where they rise above the vertex, as in a room's corner or in a furrow.
class VertexFan {
 public:
  /// `faces`: the triangles with a corner at the vertex's position.
  VertexFan(const TriangleMesh& mesh, std::uint32_t vertex, std::span<const std::uint32_t> faces);

  /// Whether any ray over the hemisphere can go through the faces; not where all of them lie below
  /// the plane of the normal.
  bool mayBlock() const { return !sectors_.empty(); }

  /// The face of the fan that a blocked ray sees.
  struct Face {
    std::uint32_t triangle;
    int corner;  ///< the one at the vertex
    bool lit;    ///< seen from the side of its normals
  };

  /// The face that blocks a direction of the hemisphere; none when it leaves on the lit side. From
  /// a point next to the vertex, just above one of its own faces, a ray crosses the fan an odd
  /// number of times when it ends on the other side.
  std::optional<Face> blockingFace(const glm::dvec3& direction) const;

 private:
  struct Sector {
    Face face;
    glm::dvec3 normal;
    glm::dvec3 first, second;  ///< a point's shares of the edges are its products with these
  };

  std::vector<Sector> sectors_;
  glm::dvec3 start_{0};
};

}  // namespace haarlight
