#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "mesh/triangle_mesh.h"
#include "spheres/sphere_set.h"

namespace haarlight {

struct SphereFitOptions {
  std::uint64_t seed = 0;
  /// Called with the finished part, 0 … 1, now and then; from several threads, but one at a time.
  std::function<void(double)> progress;
};

/// Stands in for a mesh by up to `count` spheres that cover its surface and bulge out of it as
/// little as possible; fewer only where no further sphere would lower the volume outside.
///
/// Starting from clusters of surface points, again from clusters of surface and interior points,
/// and from a single sphere, the spheres are moved, merged and split so that their summed volume
/// outside the mesh falls (SphereCover, after the goal of Wang et al. 2006, "Variational sphere set
/// approximation for solid objects"); the best result is taken. Every vertex that triangles use,
/// every triangle's centre, and points spread densely over the surface lie in a sphere, in float
/// arithmetic. Where a mesh encloses no volume, the volume of the spheres is what is kept small.
/// The result depends on mesh, count and seed alone; meshName is left empty. Throws InputError when
/// count is not from 1 to maximumSphereCount or the mesh has no triangle.
SphereSet fitSpheres(const TriangleMesh& mesh, std::size_t count,
                     const SphereFitOptions& options = {});

}  // namespace haarlight
