#include "shadow/box_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "error_text.h"
#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::vector<AxisBox> randomBoxes(int count, RandomNumbers& random) {
  std::vector<AxisBox> result;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 lower = randomPoint(random, 5);
    result.push_back({lower, lower + glm::abs(randomPoint(random, 1))});
  }
  return result;
}

/// The objects below a node, ascending, having checked that every box is the smallest around them.
std::vector<std::uint32_t> objectsBelow(const BoxTree& tree, std::uint32_t index,
                                        const std::vector<AxisBox>& boxes) {
  const BoxTree::Node& node = tree.nodes()[index];
  std::vector<std::uint32_t> result;
  if (node.isLeaf()) result.push_back(node.object);
  if (!node.isLeaf())
    for (const std::uint32_t child : node.children) {
      REQUIRE(child < index);
      const auto below = objectsBelow(tree, child, boxes);
      result.insert(result.end(), below.begin(), below.end());
    }
  std::sort(result.begin(), result.end());
  AxisBox expected;
  for (const std::uint32_t object : result) expected = united(expected, boxes[object]);
  REQUIRE(node.box == expected);
  return result;
}

int depthBelow(const BoxTree& tree, std::uint32_t index) {
  const BoxTree::Node& node = tree.nodes()[index];
  if (node.isLeaf()) return 0;
  return 1 + std::max(depthBelow(tree, node.children[0]), depthBelow(tree, node.children[1]));
}

}  // namespace

TEST_CASE("a tree has every object once, the smallest boxes, and no more levels than needed") {
  RandomNumbers random(1);
  for (const int count : {1, 2, 3, 7, 100, 1000}) {
    const auto boxes = randomBoxes(count, random);
    const BoxTree tree(boxes);
    CHECK(tree.nodes().size() == 2 * count - 1);
    const auto objects = objectsBelow(tree, tree.root(), boxes);
    REQUIRE(int(objects.size()) == count);
    for (int i = 0; i < count; ++i) CHECK(int(objects[i]) == i);
    CHECK(depthBelow(tree, tree.root()) == int(std::ceil(std::log2(count))));
  }
}

TEST_CASE("what stands apart is parted first") {
  std::vector<AxisBox> boxes;
  for (const double x : {0.0, 10.0, 1.0, 11.0}) boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  const BoxTree tree(boxes);
  const auto& root = tree.nodes()[tree.root()];
  CHECK(objectsBelow(tree, root.children[0], boxes) == std::vector<std::uint32_t>{0, 2});
  CHECK(objectsBelow(tree, root.children[1], boxes) == std::vector<std::uint32_t>{1, 3});
}

TEST_CASE("boxes that coincide still make a tree") {
  const std::vector<AxisBox> boxes(50, AxisBox{{0, 0, 0}, {1, 1, 1}});
  const BoxTree tree(boxes);
  CHECK(objectsBelow(tree, tree.root(), boxes).size() == 50);
  CHECK(depthBelow(tree, tree.root()) == 6);
}

TEST_CASE("each family has a node of its own") {
  RandomNumbers random(2);
  const auto boxes = randomBoxes(10, random);
  // The source's figure: ten objects, families [89], [56], [13], [024] and [0123456].
  const Family large{{}, {{{5, 6}, {}}, {{1, 3}, {}}, {{0, 2, 4}, {}}}};
  const std::vector<Family> families{{{8, 9}, {}}, large};
  const BoxTree tree(boxes, families);
  CHECK(tree.nodes().size() == 19);
  CHECK(objectsBelow(tree, tree.root(), boxes).size() == 10);
  std::vector<std::vector<std::uint32_t>> sets;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i)
    sets.push_back(objectsBelow(tree, i, boxes));
  for (const std::vector<std::uint32_t>& family : std::vector<std::vector<std::uint32_t>>{
           {8, 9}, {5, 6}, {1, 3}, {0, 2, 4}, {0, 1, 2, 3, 4, 5, 6}})
    CHECK(std::count(sets.begin(), sets.end(), family) == 1);
}

TEST_CASE("no objects, or none with a box, make an empty tree") {
  CHECK(BoxTree({}).isEmpty());
  CHECK(BoxTree(std::vector<AxisBox>(3)).isEmpty());
  CHECK(BoxTree({}, std::vector<Family>(2)).isEmpty());
  const std::vector<AxisBox> boxes{{}, {{0, 0, 0}, {1, 1, 1}}, {}};
  const BoxTree tree(boxes, std::vector<Family>{{{0, 2}, {}}});
  CHECK(objectsBelow(tree, tree.root(), boxes) == std::vector<std::uint32_t>{1});
}

TEST_CASE("families and boxes that make no sense are refused") {
  RandomNumbers random(3);
  auto boxes = randomBoxes(3, random);
  const auto refusal = [&](const std::vector<Family>& families) {
    return inputErrorOf([&] { BoxTree(boxes, families); });
  };
  CHECK(refusal({{{0, 3}, {}}}) == "a family names object 3, but there are only 3, counted from 0");
  CHECK(refusal({{{0, 1}, {}}, {{1}, {}}}) ==
        "object 1 is named twice in families; it can have one place only");
  CHECK(contains(refusal({{{0}, {{{0}, {}}}}}), "object 0 is named twice"));
  boxes[2].upper.y = INFINITY;
  CHECK(refusal({}) == "object 2: its box must have finite coordinates to take part in shadows");
}
