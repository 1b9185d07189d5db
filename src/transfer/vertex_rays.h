#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mesh/ray_scene.h"
#include "mesh/triangle_mesh.h"
#include "transfer/cosine_directions.h"
#include "transfer/vertex_faces.h"
#include "transfer/vertex_fan.h"

namespace haarlight {

/// A point of a mesh's surface in eight bytes: its triangle, and the weights of the triangle's
/// second and third vertex in units of 1/65535.
struct SurfacePlace {
  std::uint32_t triangle;
  std::uint16_t second, third;

  /// Weights of the three vertices; they add up to 1.
  glm::vec3 weights() const {
    const float v = static_cast<float>(second) / 65535, w = static_cast<float>(third) / 65535;
    return {1 - v - w, v, w};
  }
};

/// What a vertex's rays meet.
struct VertexView {
  std::vector<glm::vec3> directions;  ///< unit; each stands for the same cosine-weighted part
  std::vector<std::uint8_t> blocked;  ///< by direction
  std::size_t blockedCount = 0;
  std::vector<SurfacePlace> reflectors;  ///< where blocked rays meet the lit side of the mesh
};

/// Rays from the vertices of a mesh over the hemispheres of their normals.
///
/// Faces block from both sides. The faces that share the vertex's position are passed through by
/// the rays, which start on them; what goes through them to their other side is blocked all the
/// same (VertexFan). Every vertex has its own turn of the directions, from its number and the seed
/// alone, so that the errors of neighbours do not form patterns and nothing depends on threads.
class VertexRays {
 public:
  /// Keeps a reference to the mesh, which needs a normal per vertex and finite coordinates
  /// (std::invalid_argument).
  VertexRays(const TriangleMesh& mesh, int raysPerVertex, std::uint64_t seed);

  /// Any thread may call.
  void cast(std::uint32_t vertex, VertexView& view) const;

 private:
  void castPacket(std::uint32_t vertex, const VertexFan& fan, std::size_t first,
                  VertexView& view) const;
  std::optional<TriangleHit> beyondOwnFaces(std::uint32_t vertex, const glm::vec3& direction,
                                            TriangleHit hit) const;
  bool hasCornerAt(std::uint32_t triangle, const glm::vec3& position) const;
  bool meetsLitSide(const TriangleHit& hit, const glm::vec3& direction) const;

  const TriangleMesh& mesh_;
  RayScene scene_;
  VertexFaces faces_;
  CosineDirections directions_;
  std::uint64_t seed_;
  float near_;
};

}  // namespace haarlight
