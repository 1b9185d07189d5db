#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh_shadow/lit_mesh.h"

namespace haarlight {

/// For every triangle of a mesh, 1 only if the mesh is a surface around it: its corners belong to
/// no triangle that another crosses (`crossed`, findCrossedTriangles) and to no edge of more than
/// two triangles, and around each of them the triangles follow each other once, unless the mesh
/// ends there.
std::vector<std::uint8_t> findPlainTriangles(const LitMesh& mesh,
                                             std::span<const std::uint8_t> crossed);

}  // namespace haarlight
