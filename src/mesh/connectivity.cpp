#include "mesh/connectivity.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace haarlight {

WeldedMesh weld(const TriangleMesh& mesh) {
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = mesh.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> order(mesh.positions.size()), number(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });

  WeldedMesh welded;
  for (const std::uint32_t vertex : order) {
    const glm::vec3 position = mesh.positions[vertex] + 0.0f;  // −0 + 0 is 0
    if (welded.positions.empty() || welded.positions.back() != position)
      welded.positions.push_back(position);
    number[vertex] = static_cast<std::uint32_t>(welded.positions.size() - 1);
  }
  welded.triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    welded.triangles.push_back({number[t.x], number[t.y], number[t.z]});
  return welded;
}

std::vector<EdgeUse> sortedEdgeUses(std::span<const VertexTriple> triangles) {
  // By their lower vertices first, which are numbers below a known one; few uses share one.
  std::uint32_t vertices = 0;
  for (const VertexTriple& t : triangles) vertices = std::max({vertices, t[0], t[1], t[2]});
  std::vector<std::uint32_t> next(std::size_t(vertices) + 2);
  const auto forEachUse = [&](const auto& visit) {
    std::uint32_t corner = 0;
    for (const VertexTriple& t : triangles)
      for (int i = 0; i < 3; ++i, ++corner) {
        const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
        visit(EdgeUse{low, high, corner});
      }
  };
  forEachUse([&](const EdgeUse& use) { ++next[use.low + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<EdgeUse> uses(3 * triangles.size());
  forEachUse([&](const EdgeUse& use) { uses[next[use.low]++] = use; });
  // Now next[vertex] is where the uses of that lower vertex end.
  auto first = uses.begin();
  for (std::uint32_t vertex = 0; vertex <= vertices && first != uses.end(); ++vertex) {
    const auto end = uses.begin() + next[vertex];
    std::sort(first, end);
    first = end;
  }
  return uses;
}

DisjointSets::DisjointSets(std::size_t count) : parent_(count), side_(count) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

DisjointSets::Member DisjointSets::find(std::uint32_t item) {
  bool side = false;
  while (parent_[item] != item) {
    // Each item passed is hung on its grandparent, which keeps the ways short.
    const std::uint32_t parent = parent_[item];
    side_[item] ^= side_[parent];
    parent_[item] = parent_[parent];
    side ^= side_[item] != 0;
    item = parent_[item];
  }
  return {item, side};
}

void DisjointSets::join(std::uint32_t a, std::uint32_t b, bool differentSides) {
  const Member first = find(a), second = find(b);
  if (first.set == second.set) return;
  parent_[second.set] = first.set;
  side_[second.set] = first.side ^ second.side ^ differentSides;
}

}  // namespace haarlight
