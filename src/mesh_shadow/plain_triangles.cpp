#include "mesh_shadow/plain_triangles.h"

#include <algorithm>
#include <utility>

namespace haarlight {

namespace {

/// What is known of the triangles around a vertex.
struct Corner {
  std::uint32_t triangles = 0, first = 0;  ///< how many, and one of them
  bool isCrossed = false, isBorder = false, isBranch = false;
};

std::vector<Corner> lookAround(const LitMesh& mesh, std::span<const std::uint8_t> crossed) {
  std::vector<Corner> result(mesh.positions().size());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int i = 0; i < 3; ++i) {
      Corner& corner = result[mesh.triangles()[t][i]];
      ++corner.triangles, corner.first = t;
      corner.isCrossed = corner.isCrossed || crossed[t];
      for (const int edge : {i, (i + 2) % 3}) {
        corner.isBorder = corner.isBorder || mesh.neighbor(t, edge) == LitMesh::border;
        corner.isBranch = corner.isBranch || mesh.neighbor(t, edge) == LitMesh::branch;
      }
    }
  return result;
}

/// How many triangles follow each other around a vertex all of whose edges are of two.
std::uint32_t stepsAround(const LitMesh& mesh, std::uint32_t vertex, std::uint32_t first) {
  std::uint32_t count = 0, triangle = first, last = LitMesh::border;
  do {
    const VertexTriple& t = mesh.triangles()[triangle];
    const int corner = int(std::ranges::find(t, vertex) - t.begin());
    const std::uint32_t one = mesh.neighbor(triangle, corner);
    const std::uint32_t other = mesh.neighbor(triangle, (corner + 2) % 3);
    last = std::exchange(triangle, one == last ? other : one);
    ++count;
  } while (triangle != first);
  return count;
}

}  // namespace

std::vector<std::uint8_t> findPlainTriangles(const LitMesh& mesh,
                                             std::span<const std::uint8_t> crossed) {
  const std::vector<Corner> corners = lookAround(mesh, crossed);
  std::vector<std::uint8_t> isPlainAt(corners.size());
  for (std::uint32_t vertex = 0; vertex < corners.size(); ++vertex) {
    const Corner& c = corners[vertex];
    isPlainAt[vertex] = !c.isCrossed && !c.isBranch && c.triangles > 0 &&
                        (c.isBorder || stepsAround(mesh, vertex, c.first) == c.triangles);
  }
  std::vector<std::uint8_t> plain(mesh.triangleCount());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t)
    plain[t] = std::ranges::all_of(mesh.triangles()[t],
                                   [&](std::uint32_t vertex) { return isPlainAt[vertex] != 0; });
  return plain;
}

}  // namespace haarlight
