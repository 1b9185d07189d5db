#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh_file.h"

namespace haarlight {

/// How many vertices the mesh's file has, without those that loading repeats.
std::size_t fileVertexCount(const LoadedMesh& mesh);

/// Positions of the vertices in a file, brought into the order of the mesh's own vertices.
std::vector<glm::vec3> inMeshOrder(std::span<const glm::vec3> filePositions,
                                   std::span<const std::uint32_t> sourceVertices);

/// The triangles with the numbers that their vertices have in the file.
std::vector<glm::uvec3> trianglesInFile(const LoadedMesh& mesh);

}  // namespace haarlight
