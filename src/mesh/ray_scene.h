#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "mesh/occluder.h"
#include "mesh/triangle_mesh.h"
#include "visibility/sphere.h"

namespace haarlight {

/// Where a ray meets a triangle or a solid. On a solid there is neither a triangle nor a place in
/// it (both are 0), and both normals are the surface's own, outwards.
struct RayHit {
  std::uint32_t object = 0;    ///< index of the mesh or solid in the scene
  std::uint32_t triangle = 0;  ///< index of the triangle in the mesh
  glm::vec2 barycentric{0};    ///< weights of the triangle's second and third vertex
  float distance = 0;          ///< in lengths of the ray's direction
  glm::vec3 position{0};
  glm::vec3 shadingNormal{0};    ///< unit, interpolated between the vertices' where they have any
  glm::vec3 geometricNormal{0};  ///< unit, on the side from which the winding is counter-clockwise
};

/// What a ray meets first, in numbers only; as RayHit.
struct TriangleHit {
  std::uint32_t object, triangle;
  glm::vec2 barycentric;  ///< weights of the triangle's second and third vertex
  float distance;         ///< in lengths of the ray's direction
};

/// Triangle meshes and solids, or spheres, prepared for ray queries by Embree. Solids are met by
/// their formulas, in double precision, and count as filled for occluded and occluded16. Directions
/// need not be unit vectors; a ray starts at origin + near · direction and has no end but where one
/// is given. Queries may run on any number of threads.
class RayScene {
 public:
  /// Object i is *meshes[i]; the meshes are copied. Throws std::runtime_error with Embree's words
  /// when it cannot build the scene.
  explicit RayScene(std::span<const TriangleMesh* const> meshes);
  explicit RayScene(const TriangleMesh& mesh);
  /// Object i is *occluders[i]; all are copied.
  explicit RayScene(std::span<const Occluder> occluders);
  /// Spheres instead of triangles: for occluded and occluded16 only.
  explicit RayScene(std::span<const Sphere> spheres);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  std::optional<RayHit> closestHit(const glm::vec3& origin, const glm::vec3& direction,
                                   float near = 0) const;

  /// Sixteen rays from one point at once; bit i of `valid` says whether ray i counts. Bit i of the
  /// result is set, and hits[i] filled, when ray i counts and meets something.
  std::uint16_t closestHits16(const glm::vec3& origin, std::span<const glm::vec3, 16> directions,
                              std::span<TriangleHit, 16> hits, std::uint16_t valid = 0xffff,
                              float near = 0) const;

  bool occluded(const glm::vec3& origin, const glm::vec3& direction, float near = 0) const;

  /// Sixteen rays at once, which end at origin + far · direction; bit i of `valid` says whether ray
  /// i counts. Bit i of the result is set when ray i counts and meets something.
  std::uint16_t occluded16(std::span<const glm::vec3, 16> origins,
                           std::span<const glm::vec3, 16> directions, std::uint16_t valid = 0xffff,
                           float near = 0,
                           float far = std::numeric_limits<float>::infinity()) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace haarlight
