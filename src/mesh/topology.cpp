#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace haarlight {

namespace {

using VertexTriangle = std::array<std::uint32_t, 3>;

/// The number of the first vertex at the same position, for every vertex.
std::vector<std::uint32_t> firstAtPosition(const std::vector<glm::vec3>& positions) {
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = positions[i];
    return std::tuple(p.x, p.y, p.z, i);
  };
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
        i > 0 && positions[order[i]] == positions[order[i - 1]] ? first[order[i - 1]] : order[i];
  return first;
}

std::vector<VertexTriangle> weldedTriangles(const TriangleMesh& mesh) {
  const auto first = firstAtPosition(mesh.positions);
  std::vector<VertexTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) triangles.push_back({first[t.x], first[t.y], first[t.z]});
  return triangles;
}

void countEdges(const std::vector<VertexTriangle>& triangles, MeshTopology& topology) {
  std::vector<std::pair<std::uint64_t, bool>> edges;  // smaller and larger vertex, direction
  edges.reserve(3 * triangles.size());
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      edges.emplace_back(std::min(a, b) << 32 | std::max(a, b), a < b);
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].first == edges[begin].first) ++end;
    ++topology.edges;
    topology.boundaryEdges += end - begin == 1;
    topology.nonManifoldEdges += end - begin > 2;
    topology.misorientedEdges += end - begin == 2 && edges[begin].second == edges[begin + 1].second;
  }
  topology.closed = topology.boundaryEdges == 0 && topology.nonManifoldEdges == 0;
}

void countDuplicates(std::vector<VertexTriangle> triangles, MeshTopology& topology) {
  for (auto& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  const auto distinct = std::unique(triangles.begin(), triangles.end()) - triangles.begin();
  topology.duplicateTriangles = triangles.size() - std::size_t(distinct);
}

void countComponents(const std::vector<VertexTriangle>& triangles, std::size_t vertexCount,
                     MeshTopology& topology) {
  std::vector<std::uint32_t> parent(vertexCount);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<bool> used(vertexCount);
  for (const auto& t : triangles)
    for (const std::uint32_t vertex : t) {
      used[vertex] = true;
      parent[root(vertex)] = root(t[0]);
    }
  for (std::uint32_t i = 0; i < vertexCount; ++i) {
    topology.vertices += used[i];
    topology.components += used[i] && root(i) == i;
  }
}

}  // namespace

MeshTopology measureTopology(const TriangleMesh& mesh) {
  MeshTopology topology;
  const auto triangles = weldedTriangles(mesh);
  countEdges(triangles, topology);
  countDuplicates(triangles, topology);
  countComponents(triangles, mesh.positions.size(), topology);
  return topology;
}

}  // namespace haarlight
