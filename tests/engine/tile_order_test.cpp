#include "engine/tile_order.h"

#include <algorithm>

#include "test_support.h"

using namespace haarlight;

namespace {

/// Whether 16 cells that follow each other are one square of 4 x 4.
bool isSquare(std::span<const std::uint32_t> cells, std::uint32_t columns) {
  const std::uint32_t row = cells[0] / columns, column = cells[0] % columns;
  return std::ranges::all_of(cells, [&](std::uint32_t cell) {
    return cell / columns - row < 4 && cell % columns - column < 4;
  });
}

}  // namespace

TEST_CASE("a grid's tiles of 16 are squares, and every cell is there once") {
  for (const auto& [columns, rows] :
       {std::pair{8, 4}, {4, 12}, {128, 128}, {7, 9}, {1, 5}, {3, 1}}) {
    CAPTURE(columns);
    CAPTURE(rows);
    auto order = tileOrder(columns, rows);
    for (std::size_t i = 0; columns % 4 == 0 && rows % 4 == 0 && i < order.size(); i += 16)
      CHECK(isSquare(std::span(order).subspan(i, 16), columns));
    std::ranges::sort(order);
    REQUIRE(order.size() == std::size_t(columns * rows));
    for (std::size_t i = 0; i < order.size(); ++i) CHECK(order[i] == i);
  }
}

TEST_CASE("a grid without cells has no order") {
  CHECK(tileOrder(0, 4).empty());
  CHECK(tileOrder(4, 0).empty());
}

TEST_CASE("elements are taken in the order") {
  const std::vector<int> grid{10, 11, 12};
  const std::vector<std::uint32_t> order{2, 0, 1};
  CHECK(inOrder(grid, order) == std::vector<int>{12, 10, 11});
}
