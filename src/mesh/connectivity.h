#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// The three vertices of a triangle.
using VertexTriple = std::array<std::uint32_t, 3>;

/// A mesh without normals in which every position is one vertex.
struct WeldedMesh {
  std::vector<glm::vec3> positions;  ///< in order of x, y, z; −0 is 0
  std::vector<VertexTriple> triangles;
};

/// Joins the vertices at the same position. Coordinates must be finite.
WeldedMesh weld(const TriangleMesh& mesh);

/// One triangle's use of an edge: its corner % 3-th, of triangle corner / 3.
struct EdgeUse {
  std::uint32_t low, high;  ///< the vertices, low < high
  std::uint32_t corner;     ///< 3 · triangle + number of the corner that the edge starts from

  std::uint32_t triangle() const { return corner / 3; }
  auto operator<=>(const EdgeUse&) const = default;
};

/// All edges of all triangles, sorted, so that the uses of an edge follow each other.
std::vector<EdgeUse> sortedEdgeUses(std::span<const VertexTriple> triangles);

/// Whether the triangle runs through the edge from `low` to `high`.
inline bool runsUpward(std::span<const VertexTriple> triangles, const EdgeUse& use) {
  return triangles[use.triangle()][use.corner % 3] == use.low;
}

/// Calls visit(uses) with all uses of each edge.
template <typename Visit>
void forEachEdge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low &&
           uses[end].high == uses[begin].high)
      ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

/// Items that are joined into sets, each with a side, 0 or 1, known relative to the others of its
/// set.
class DisjointSets {
 public:
  struct Member {
    std::uint32_t set;  ///< the item that stands for the set
    bool side;          ///< relative to that item
  };

  explicit DisjointSets(std::size_t count);

  Member find(std::uint32_t item);

  /// Joins the sets of two items that lie on different sides or on the same. Does nothing when the
  /// two are in one set already.
  void join(std::uint32_t a, std::uint32_t b, bool differentSides = false);

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> side_;  ///< relative to the parent
};

}  // namespace haarlight
