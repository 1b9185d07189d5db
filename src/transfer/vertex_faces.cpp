#include "transfer/vertex_faces.h"

#include <numeric>

#include "mesh/connectivity.h"

namespace haarlight {

VertexFaces::VertexFaces(const TriangleMesh& mesh) : positionOf_(mesh.positions.size(), unused) {
  const WeldedMesh welded = weld(mesh);
  begin_.resize(welded.positions.size() + 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      positionOf_[mesh.triangles[t][corner]] = welded.triangles[t][corner];
      ++begin_[welded.triangles[t][corner] + 1];
    }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  triangles_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t position : welded.triangles[t])
      triangles_[next[position]++] = static_cast<std::uint32_t>(t);
}

std::span<const std::uint32_t> VertexFaces::around(std::uint32_t vertex) const {
  const std::uint32_t position = positionOf_[vertex];
  if (position == unused) return {};
  return std::span(triangles_).subspan(begin_[position], begin_[position + 1] - begin_[position]);
}

}  // namespace haarlight
