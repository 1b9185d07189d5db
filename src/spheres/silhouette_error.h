#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"
#include "spheres/sphere_set.h"
#include "spheres/viewpoints.h"

namespace haarlight {

struct SilhouetteSampling {
  std::size_t viewpoints = 200;
  std::size_t raysPerViewpoint = 4096;
  ViewpointRange range = {};
  std::uint64_t seed = 0;
};

/// Compares the outlines of spheres and mesh by rays from viewpoints around the mesh. Viewpoints
/// that do not see the mesh, as beside a flat sheet, do not count; zero when none does. The mean
/// over the default 200 viewpoints is within about 2 % of itself.
SilhouetteError silhouetteError(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                                const SilhouetteSampling& sampling = {});

}  // namespace haarlight
