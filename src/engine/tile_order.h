#pragma once

/// The order of receivers that lie in a grid.

#include <cstdint>
#include <span>
#include <vector>

namespace haarlight {

/// Cells of a grid, row * columns + column, in tiles of 4 × 4, tile by tile. On CPUs engines take
/// 16 receivers that follow each other against one sphere, and pass over what none of them can see:
/// the closer they are, the less there is to do. Radiance is the same in any order.
std::vector<std::uint32_t> tileOrder(int columns, int rows);

/// The elements of a grid in that order.
template <typename Element>
std::vector<Element> inOrder(const std::vector<Element>& grid,
                             std::span<const std::uint32_t> order) {
  std::vector<Element> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t cell : order) ordered.push_back(grid[cell]);
  return ordered;
}

}  // namespace haarlight
