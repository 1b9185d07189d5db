#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh/triangle_mesh.h"
#include "spheres/sphere_set.h"

namespace haarlight {

/// Part of `samples` points spread over the mesh's surface that lie in one of the spheres.
double coveredFraction(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                       std::size_t samples, std::uint64_t seed);

/// E = Σ V(S_i − T) / V(T), from about `samples` points spread over the spheres in proportion to
/// their volumes and tested by InsideTest. V(T) is exact for a closed mesh of one part, else also
/// estimated, with as many points. None when the mesh encloses no volume. The standard error is
/// about ΣV(S_i) / V(T) / (2 √samples).
std::optional<double> outsideVolumeRatio(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                                         std::size_t samples, std::uint64_t seed);

/// Both of them.
SphereMeasures measureSpheres(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                              std::size_t samples = 100000, std::uint64_t seed = 0);

}  // namespace haarlight
