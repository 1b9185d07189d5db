#include "shadow/shadow_octree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "error_text.h"
#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A cube divided at random down to `depth`; some cells are left out.
void divide(const CellCode& cell, int depth, RandomNumbers& random,
            std::vector<ShadowLeaf>& leaves) {
  const auto chance = random() % 8;
  if (cell.depth == depth || (chance == 0 && cell.depth > 0)) {
    if (chance != 1) leaves.push_back({cell, chance % 2 == 0, false});
    return;
  }
  for (std::uint32_t i = 0; i < 8; ++i) divide(cell.child(i), depth, random, leaves);
}

}  // namespace

TEST_CASE("a cell's code interleaves its coordinates, x lowest") {
  CHECK(deepestCellAt({0, 0, 0}).first == 0);
  CHECK(deepestCellAt({1, 0, 0}).first == 1);
  CHECK(deepestCellAt({0, 1, 0}).first == 2);
  CHECK(deepestCellAt({0, 0, 1}).first == 4);
  CHECK(deepestCellAt({3, 5, 6}).first == 0b110'101'011);
  CHECK(deepestCellAt({1023, 1023, 1023}).first == (1u << 30) - 1);
  for (const glm::uvec3 c : {glm::uvec3(3, 5, 6), glm::uvec3(1023, 0, 512), glm::uvec3(7, 1000, 1)})
    CHECK(deepestCellAt(c).coordinates() == c);
}

TEST_CASE("eight children fill their cell in the order of their codes") {
  const CellCode root;
  CHECK(root.span() == 1u << 30);
  CellCode cell = root.child(5).child(3);
  CHECK(cell.depth == 2);
  CHECK(cell.coordinates() == glm::uvec3(512 + 256, 256, 512));
  std::uint32_t next = cell.first;
  for (std::uint32_t i = 0; i < 8; ++i) {
    CHECK(cell.child(i).first == next);
    next += cell.child(i).span();
  }
  CHECK(next == cell.first + cell.span());
}

TEST_CASE("cells are cubes that halve the longest edge of the receiver's box") {
  OctreeCube cube;
  cube.lower = {-1, 0, 2}, cube.edge = 4;
  CHECK(cube.box({}) == AxisBox{{-1, 0, 2}, {3, 4, 6}});
  CHECK(cube.box(CellCode{}.child(1).child(4)) == AxisBox{{1, 0, 3}, {2, 1, 4}});
  CHECK(cube.edgeAt(10) == 4.0 / 1024);
}

TEST_CASE("a receiver's cube holds its box, and no face of the box lies between cells") {
  for (const double size : {1.0, 0.5, 0.25, 0.75, 1.0 / 1024}) {
    const AxisBox box{{-1, 0, 2}, glm::dvec3(-1, 0, 2) + 4.0 * glm::dvec3(1, size, 1)};
    const OctreeCube cube(box);
    CHECK(cube.edge > 4);
    CHECK(cube.edge < 4 + 4.0 / 1024);
    CHECK(cube.box({}).contains(box.lower));
    CHECK(cube.box({}).contains(box.upper));
    for (const double y : {box.lower.y, box.upper.y}) {
      const double place = (y - cube.lower.y) / cube.edgeAt(10);
      CHECK(std::abs(place - std::round(place)) > 1e-2);
    }
  }
}

TEST_CASE("detail is the largest edge that the smallest cells may have") {
  const OctreeCube cube(AxisBox{{0, 0, 0}, {1, 1, 1}});
  CHECK(cube.depthForDetail(2) == 0);
  CHECK(cube.depthForDetail(1) == 0);
  CHECK(cube.depthForDetail(0.1) == 4);
  CHECK(cube.depthForDetail(0.02) == 6);
  CHECK(cube.depthForDetail(0.001) == 10);
  CHECK(cube.depthForDetail(1e-9) == 10);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK(contains(inputErrorOf([&] { cube.depthForDetail(wrong); }), "level of detail"));
}

TEST_CASE("a point is found in the leaf whose box holds it, or in none") {
  RandomNumbers random(1);
  const OctreeCube cube(AxisBox{{-1, -2, 3}, {1, 1, 5}});
  std::vector<ShadowLeaf> leaves;
  divide({}, 4, random, leaves);
  auto shuffled = leaves;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const ShadowOctree octree(cube, shuffled);
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 point = cube.lower + 1.5 + randomPoint(random, 1.5);
    const auto holds = [&](const ShadowLeaf& leaf) { return cube.box(leaf.cell).contains(point); };
    const auto expected = std::find_if(leaves.begin(), leaves.end(), holds);
    const auto leaf = octree.leafAt(point);
    REQUIRE((leaf != nullptr) == (expected != leaves.end()));
    if (!leaf) continue;
    ++found;
    CHECK(leaf->cell == expected->cell);
    CHECK(octree.isInShadow(point) == expected->inShadow);
  }
  CHECK(found > 1500);
  CHECK(found < 3000);
}

TEST_CASE("an octree without leaves, and one of a single point") {
  CHECK_FALSE(ShadowOctree().leafAt({0, 0, 0}));
  CHECK_FALSE(ShadowOctree().isInShadow({0, 0, 0}));
  const OctreeCube point(AxisBox{{1, 2, 3}, {1, 2, 3}});
  CHECK(point.depthForDetail(0.1) == 0);
  CHECK(ShadowOctree(point, {{CellCode{}, true, false}}).isInShadow({1, 2, 3}));
}
