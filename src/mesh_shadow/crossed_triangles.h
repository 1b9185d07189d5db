#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/connectivity.h"
#include "mesh_shadow/triangle_box.h"

namespace haarlight {

/// For every triangle of a mesh, 0 only if it has no point in common with any other triangle but
/// for the corners that both have, and the edge between these. In doubt, as of triangles whose
/// distance is next to rounding, 1; all are in doubt where more lie next to each other than can be
/// compared. Corners at one position must have one number. Uses all threads.
std::vector<std::uint8_t> findCrossedTriangles(std::span<const BoxedTriangle> triangles,
                                               std::span<const VertexTriple> corners);

}  // namespace haarlight
