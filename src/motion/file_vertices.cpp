#include "motion/file_vertices.h"

#include <algorithm>

namespace haarlight {

std::size_t fileVertexCount(const LoadedMesh& mesh) {
  const std::vector<std::uint32_t>& sources = mesh.sourceVertices;
  return sources.empty() ? 0 : std::size_t(*std::ranges::max_element(sources)) + 1;
}

std::vector<glm::vec3> inMeshOrder(std::span<const glm::vec3> filePositions,
                                   std::span<const std::uint32_t> sourceVertices) {
  std::vector<glm::vec3> positions;
  positions.reserve(sourceVertices.size());
  for (const std::uint32_t source : sourceVertices) positions.push_back(filePositions[source]);
  return positions;
}

std::vector<glm::uvec3> trianglesInFile(const LoadedMesh& mesh) {
  const std::vector<std::uint32_t>& sources = mesh.sourceVertices;
  std::vector<glm::uvec3> triangles;
  triangles.reserve(mesh.mesh.triangles.size());
  for (const glm::uvec3& t : mesh.mesh.triangles)
    triangles.emplace_back(sources[t.x], sources[t.y], sources[t.z]);
  return triangles;
}

}  // namespace haarlight
