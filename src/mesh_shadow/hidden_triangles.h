#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh_shadow/lit_mesh.h"

namespace haarlight {

/// For every triangle of a mesh, 1 only if all of it, but for its edges, lies in the shadow of
/// other triangles, as the parts of a solid do that face away from the light.
///
/// A closed mesh gives each point off it a winding number. Along a triangle that no other crosses
/// the number does not change, on either side; nor does it across an edge of two such triangles.
/// On its way to the light it must become that of the light. So where it differs there is a
/// triangle in the way, and for a whole sheet of triangles one ray tells, on which all triangles
/// are counted. Sheets beyond the largest ones, and meshes that are not closed, stay unknown, as do
/// triangles of `crossed` (findCrossedTriangles).
std::vector<std::uint8_t> findHiddenTriangles(const LitMesh& mesh,
                                              std::span<const std::uint8_t> crossed);

}  // namespace haarlight
