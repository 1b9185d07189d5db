#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "transfer/light_transport.h"

namespace haarlight {

/// What a transfer takes into account.
enum class TransferKind : std::uint32_t {
  unshadowed,     ///< the cosine alone
  shadowed,       ///< also that the mesh blocks light
  interreflected  ///< also light that the mesh reflects onto itself
};

/// "unshadowed", "shadowed" or "interreflected".
std::string transferKindName(TransferKind kind);

inline constexpr int maximumTransferOrder = 20;
inline constexpr int maximumTransferBounces = 64;
inline constexpr int maximumTransferRays = 65536;

/// Precomputed diffuse transfer (Sloan et al. 2002) of the vertices of a mesh, in the basis of
/// sh/basis.h with directions in the mesh's own coordinates.
///
/// It includes albedo/π: a channel of the radiance that leaves vertex v is Σ_i T_i L_i, where T is
/// the vertex's row and L the coefficients of the light's radiance in that channel.
struct DiffuseTransfer {
  TransferKind kind = TransferKind::unshadowed;
  int order = 0;
  int bounces = 0;        ///< reflections after the first one; 0 unless interreflected
  int raysPerVertex = 0;  ///< 0 when unshadowed
  std::uint64_t seed = 0;
  glm::vec3 albedo{0};         ///< of the whole mesh
  std::uint64_t meshHash = 0;  ///< meshHash() of the mesh
  std::size_t vertices = 0;
  int channels = 1;  ///< 1 where the albedo is grey, so that all have the same row; else 3, RGB
  /// Vertex by vertex, coefficient by coefficient, channel by channel.
  std::vector<float> values;

  int coefficients() const { return order * order; }
  std::size_t rowLength() const { return std::size_t(coefficients()) * std::size_t(channels); }
  std::span<const float> row(std::size_t vertex) const {
    return std::span(values).subspan(vertex * rowLength(), rowLength());
  }
};

struct TransferOptions {
  TransferKind kind = TransferKind::interreflected;
  int order = 5;
  int bounces = 2;  ///< of kind interreflected
  int raysPerVertex = 1024;
  glm::vec3 albedo{0.5f};
  std::uint64_t seed = 1;
};

struct TransferResult {
  DiffuseTransfer transfer;
  /// Mean over the surface of the radiance that leaves it under light of radiance 1 from everywhere
  /// and that has been reflected once, twice, …
  std::vector<glm::vec3> energyByBounce;
  double blockedPart = 0;  ///< part of all rays that met the mesh
  double raySeconds = 0;   ///< shadows included
  double bounceSeconds = 0;
};

/// Computes the transfer on all threads; the result depends on the options and not on the threads.
///
/// Bounce by bounce G_0 = 1/π ∫ V cos y, G_(b+1) = 1/π ∫ cos G_b(point seen); as the albedo a is
/// the same everywhere, the transfer is Σ a^(b+1) G_b in each channel.
///
/// Throws std::invalid_argument for options out of range (order 1 to maximumTransferOrder, bounces
/// to maximumTransferBounces and at least 1 when interreflected, rays to maximumTransferRays,
/// albedo 0 to 1) and for a mesh without normals, TransferCancelled when the monitor asks for it.
TransferResult computeTransfer(const TriangleMesh& mesh, const TransferOptions& options,
                               const TransferMonitor& monitor = {});

}  // namespace haarlight
