#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh_shadow/lit_mesh.h"

namespace haarlight {

/// What a picture's pixels see: pixel (x, y) looks along eye + t · (corner + x · column + y · row),
/// t > 0, with integers at the pixels' middles.
struct PixelView {
  glm::dvec3 eye{0}, corner{0}, column{0}, row{0};
  int width = 0, height = 0;
};

/// Shadow volumes as Crow has them (1977), what the source of the octree compares itself with: the
/// space behind every triangle, as the light sees it, is bounded by the triangle and by its edges'
/// planes through the light. Planes that two triangles share with the space on both sides are not
/// there, which leaves those of the silhouette. From the eye to a point, every face passed on the
/// way in counts 1 and on the way out −1; together with those volumes that the eye is in, that is
/// the number of triangles between the point and the light.
class ClassicVolume {
 public:
  explicit ClassicVolume(const LitMesh& mesh);

  /// Faces: triangles, and one or two triangles with corners at infinity for each side plane.
  std::size_t faceCount() const { return faces_.size(); }
  static std::size_t bytesPerFace() { return sizeof(Face); }

  /// Adds to counts[y · width + x] the number of the mesh's triangles between the light and the
  /// point at t = depths[y · width + x], which may be infinite. A face within `relativeBias` of a
  /// point, as a part of t, is not passed, so that a triangle does not hide itself where its lit
  /// side is seen; seen from behind, it does. Uses all threads.
  void addCounts(const PixelView& view, std::span<const double> depths,
                 std::span<std::int32_t> counts, double relativeBias = 1e-6) const;

 private:
  /// A point, w = 1, or a direction in which a plane goes on without an end, w = 0.
  struct Corner {
    glm::dvec3 place;
    double w;
  };
  /// Counter-clockwise from outside; `weight` volumes begin behind it.
  struct Face {
    std::array<Corner, 3> corners;
    int weight;
  };
  class Raster;

  void addCaps();
  void addSides();
  Corner beyond(std::uint32_t vertex) const;
  int countAtEye(const glm::dvec3& eye) const;

  const LitMesh& mesh_;
  std::vector<Face> faces_;
};

}  // namespace haarlight
