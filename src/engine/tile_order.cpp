#include "engine/tile_order.h"

#include <algorithm>

namespace haarlight {

std::vector<std::uint32_t> tileOrder(int columns, int rows) {
  constexpr int side = 4;
  std::vector<std::uint32_t> order;
  order.reserve(std::size_t(columns) * rows);
  for (int top = 0; top < rows; top += side)
    for (int left = 0; left < columns; left += side)
      for (int row = top; row < std::min(top + side, rows); ++row)
        for (int column = left; column < std::min(left + side, columns); ++column)
          order.push_back(std::uint32_t(row) * columns + column);
  return order;
}

}  // namespace haarlight
