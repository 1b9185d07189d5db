#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "transfer/vertex_rays.h"

namespace haarlight {

/// Thrown by a computation whose monitor has asked it to end.
class TransferCancelled : public std::runtime_error {
 public:
  TransferCancelled() : std::runtime_error("interrupted; no transfer was written") {}
};

/// Watches a computation from outside; both are called from any thread, and either may be empty.
struct TransferMonitor {
  /// What is being done, and how much of it is finished, 0 … 1.
  std::function<void(const std::string& task, double finished)> progress;
  std::function<bool()> cancelled;
};

/// One row of coefficients per vertex for 1/π ∫ max(0, ω·n) y_i(ω) dω, without any shadow: the
/// clamped cosine in closed form, turned to the normals. order² floats a vertex.
std::vector<float> unshadowedTransfer(std::span<const glm::vec3> normals, int order);

/// How light comes to the vertices of a mesh, from far away and from the mesh itself. Radiance
/// leaves diffusely, and what is given per vertex is interpolated over triangles.
class LightTransport {
 public:
  /// Casts all rays, on all threads. `keepReflectors`: for reflected(); takes eight bytes for each
  /// ray that is blocked. `vertices`: only the first so many have rays and direct() transfer, while
  /// all triangles block; nothing is reflected() then. Keeps a reference to the mesh. Throws
  /// std::invalid_argument for a wrong order, number of rays or vertices or mesh (VertexRays), and
  /// TransferCancelled.
  LightTransport(const TriangleMesh& mesh, int order, int raysPerVertex, std::uint64_t seed,
                 bool keepReflectors, const TransferMonitor& monitor = {},
                 std::optional<std::size_t> vertices = {});

  /// 1/π ∫ V(ω) max(0, ω·n) y_i(ω) dω by vertex, order² floats each; V is 0 where the mesh blocks.
  ///
  /// What is certain is not sampled: of the rays of a vertex the smaller part is summed, the
  /// visible ones, or the blocked ones to be taken from the closed form. So an open vertex has
  /// exactly the unshadowed transfer, and an enclosed one exactly none.
  const std::vector<float>& direct() const { return direct_; }

  /// 1/π ∫ max(0, ω·n) f(ω) dω by vertex, where f is what leaves the point of the mesh that is seen
  /// in direction ω, 0 in directions without any. `radiance`: `rowLength` floats per vertex, any
  /// functions of the vertices. The back of a face, away from its normals, reflects nothing. Throws
  /// TransferCancelled.
  std::vector<float> reflected(std::span<const float> radiance, std::size_t rowLength,
                               const std::string& task = "reflecting") const;

  /// Part of all rays that met the mesh.
  double blockedPart() const;

 private:
  class Stage;

  void castRange(const VertexRays& rays, std::size_t begin, std::size_t end);
  void sumDirect(const VertexView& view, std::span<float> row) const;
  void reflectRange(std::span<const float> radiance, std::size_t rowLength, std::size_t begin,
                    std::size_t end, std::vector<float>& result) const;

  const TriangleMesh& mesh_;
  int order_;
  int raysPerVertex_;
  bool keepReflectors_;
  TransferMonitor monitor_;
  std::size_t vertices_;  ///< that have rays
  std::vector<float> direct_;
  std::vector<std::vector<SurfacePlace>> reflectors_;  ///< by range of vertices, one after another
  std::vector<std::uint32_t> reflectorCounts_;         ///< by vertex
  std::vector<std::uint32_t> blockedCounts_;           ///< by vertex
};

}  // namespace haarlight
