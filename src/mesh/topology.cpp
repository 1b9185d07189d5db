#include "mesh/topology.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh/connectivity.h"

namespace haarlight {

namespace {

void countEdges(const std::vector<VertexTriple>& triangles, MeshTopology& topology) {
  forEachEdge(sortedEdgeUses(triangles), [&](std::span<const EdgeUse> uses) {
    ++topology.edges;
    topology.boundaryEdges += uses.size() == 1;
    topology.nonManifoldEdges += uses.size() > 2;
    topology.misorientedEdges +=
        uses.size() == 2 && runsUpward(triangles, uses[0]) == runsUpward(triangles, uses[1]);
  });
  topology.closed = topology.boundaryEdges == 0 && topology.nonManifoldEdges == 0;
}

void countDuplicates(std::vector<VertexTriple> triangles, MeshTopology& topology) {
  for (auto& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  const auto distinct = std::unique(triangles.begin(), triangles.end()) - triangles.begin();
  topology.duplicateTriangles = triangles.size() - std::size_t(distinct);
}

void countComponents(const WeldedMesh& mesh, MeshTopology& topology) {
  DisjointSets parts(mesh.positions.size());
  std::vector<bool> used(mesh.positions.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t vertex : t) {
      used[vertex] = true;
      parts.join(t[0], vertex);
    }
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    topology.vertices += used[i];
    topology.components += used[i] && parts.find(i).set == i;
  }
}

}  // namespace

MeshTopology measureTopology(const TriangleMesh& mesh) {
  MeshTopology topology;
  const WeldedMesh welded = weld(mesh);
  countEdges(welded.triangles, topology);
  countDuplicates(welded.triangles, topology);
  countComponents(welded, topology);
  return topology;
}

}  // namespace haarlight
