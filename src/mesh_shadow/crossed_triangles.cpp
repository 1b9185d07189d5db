#include "mesh_shadow/crossed_triangles.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "mesh_shadow/triangle_contact.h"
#include "mesh_shadow/triangle_grid.h"

namespace haarlight {

std::vector<std::uint8_t> findCrossedTriangles(std::span<const BoxedTriangle> triangles,
                                               std::span<const VertexTriple> corners) {
  const TriangleGrid grid(triangles);
  constexpr std::uint64_t mostPairsPerTriangle = 400;
  if (grid.pairCount() > mostPairsPerTriangle * triangles.size())
    return std::vector<std::uint8_t>(triangles.size(), 1);
  std::vector<std::uint8_t> crossed(triangles.size());
  const auto mark = [&](std::uint32_t triangle) {
    std::atomic_ref(crossed[triangle]).store(1, std::memory_order_relaxed);
  };
  constexpr std::size_t grain = 512;
  parallelFor(grid.cellCount(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
      grid.forEachPair(cell, [&](std::uint32_t a, std::uint32_t b) {
        if (!mayTouchElsewhere({triangles[a].corners, corners[a]},
                               {triangles[b].corners, corners[b]}))
          return;
        mark(a), mark(b);
      });
  });
  return crossed;
}

}  // namespace haarlight
