#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "spheres/sphere_set.h"

namespace haarlight {

/// Part of `samples` points spread over the mesh's surface that lie in one of the spheres.
double coveredFraction(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                       std::size_t samples, std::uint64_t seed);

/// The volumes of SphereMeasures, as parts of the mesh's volume.
struct VolumeMeasures {
  double summedOutside = 0;  ///< E = Σ V(S_i − T) / V(T)
  double unionOutside = 0;   ///< V(∪S_i − T) / V(T)
  double uncovered = 0;      ///< V(T − ∪S_i) / V(T)
};

/// From about `samples` points spread over the spheres in proportion to their volumes, and as many
/// over the mesh's bounding box, tested by InsideTest. V(T) is exact for a closed mesh of one part,
/// else estimated, too. None when the mesh encloses no volume. The standard error of E is about
/// ΣV(S_i) / V(T) / (2 √samples).
std::optional<VolumeMeasures> volumeMeasures(const TriangleMesh& mesh,
                                             std::span<const Sphere> spheres, std::size_t samples,
                                             std::uint64_t seed);

/// All of them, with silhouetteError.
SphereMeasures measureSpheres(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                              std::size_t samples = 100000, std::uint64_t seed = 0);

/// Spheres grown just enough that every point lies in one, in float arithmetic; a point that lies
/// in none goes to the sphere whose volume grows least. Sets that cover unequal parts of a mesh
/// compare only after this, since the outside volume falls steeply when a few points are left out.
std::vector<Sphere> grownToCover(std::span<const Sphere> spheres,
                                 std::span<const glm::vec3> points);

/// `count` points spread evenly over the volume that the mesh encloses; none when it encloses none.
std::vector<glm::vec3> sampleInterior(const TriangleMesh& mesh, std::size_t count,
                                      std::uint64_t seed);

}  // namespace haarlight
