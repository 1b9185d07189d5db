#include "spheres/sphere_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "mesh/random.h"
#include "spheres/enclosing_ball.h"
#include "spheres/free_disc_part.h"
#include "spheres/random_spheres.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Positions and radii of all magnitudes from 1e-6 to 1e6.
std::vector<Sphere> spheresOfAllScales(std::size_t count) {
  Random random(7);
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 center = randomDirection(random) * std::pow(10.0, 12 * random.uniform() - 6);
    spheres.push_back(
        {glm::vec3(center), static_cast<float>(std::pow(10.0, 12 * random.uniform() - 6))});
  }
  return spheres;
}

double reach(const Sphere& sphere, const glm::dvec3& center) {
  return glm::distance(glm::dvec3(sphere.center), center) + double(sphere.radius);
}

SphereTreeNode rootOf(const std::vector<Sphere>& spheres) {
  return SphereTree(spheres).nodes()[0];
}

std::size_t levels(const SphereTree& tree) {
  std::vector<std::uint32_t> open;  // ends of the subtrees around a node
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    while (!open.empty() && open.back() <= i) open.pop_back();
    open.push_back(tree.nodes()[i].next);
    most = std::max(most, open.size());
  }
  return most;
}

/// Number of leaves in the wrong place, or outside a ball around them.
int wrongLeaves(const SphereTree& tree, const std::vector<Sphere>& spheres) {
  int wrong = 0;
  for (const SphereTreeNode& node : tree.nodes()) {
    for (std::uint32_t i = 0; i < node.leafCount; ++i) {
      const Sphere& sphere = spheres[tree.leaves()[node.firstLeaf + i]];
      wrong += !(reach(sphere, node.center) <= double(node.radius));
      if (node.leafCount == 1)
        wrong += node.center != sphere.center || node.radius != sphere.radius || node.error != 0;
    }
  }
  return wrong;
}

/// Number of nodes that are not followed by their two children.
int wrongNodes(const SphereTree& tree) {
  int wrong = 0;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const SphereTreeNode& node = tree.nodes()[i];
    wrong += node.next != i + 2 * node.leafCount - 1 || !(node.error >= 0 && node.error <= 1);
    if (node.leafCount == 1) continue;
    const SphereTreeNode &first = tree.nodes()[i + 1], &second = tree.nodes()[first.next];
    wrong += first.firstLeaf != node.firstLeaf || second.next != node.next ||
             second.firstLeaf != first.firstLeaf + first.leafCount ||
             first.leafCount + second.leafCount != node.leafCount;
  }
  return wrong;
}

void checkTree(const SphereTree& tree, const std::vector<Sphere>& spheres) {
  REQUIRE(tree.nodes().size() == 2 * spheres.size() - 1);
  CHECK(tree.nodes()[0].leafCount == spheres.size());
  std::vector<std::uint32_t> indices(tree.leaves().begin(), tree.leaves().end());
  std::sort(indices.begin(), indices.end());
  for (std::uint32_t i = 0; i < spheres.size(); ++i) REQUIRE(indices[i] == i);
  CHECK(wrongNodes(tree) == 0);
  CHECK(wrongLeaves(tree, spheres) == 0);
  CHECK(double(levels(tree)) <= 16 + std::log(double(spheres.size())) / std::log(32.0 / 31));
}

}  // namespace

TEST_CASE("a sphere tree over nothing has no nodes") {
  SphereTree tree(std::span<const Sphere>{});
  CHECK(tree.nodes().empty());
  tree.visit([](const SphereTreeNode&) { return true; }, [](std::uint32_t) { CHECK(false); });
  CHECK(tree.cut({0, 0, 0}, 0.1).empty());
  tree.refit({});
  CHECK(tree.nodes().empty());
}

TEST_CASE("every ball of a sphere tree encloses its spheres") {
  for (const std::size_t count : {1, 2, 3, 4, 5, 17, 100, 4096}) {
    const std::vector<Sphere> spheres = randomSpheres(count, count);
    const SphereTree tree(spheres);
    checkTree(tree, spheres);
    CHECK(levels(tree) <= 2 + 1.5 * std::log2(double(count)));
  }
  for (const double extent : {1e-6, 1e6}) {
    const std::vector<Sphere> spheres = randomSpheres(300, 1, extent);
    checkTree(SphereTree(spheres), spheres);
    const std::vector<Sphere> far = randomSpheres(300, 2, 1, glm::dvec3(1e6, -1e6, 1e6));
    checkTree(SphereTree(far), far);
  }
  const std::vector<Sphere> mixed = spheresOfAllScales(300);
  checkTree(SphereTree(mixed), mixed);
}

TEST_CASE("the balls of a sphere tree are the smallest, and their errors what they leave free") {
  const std::vector<Sphere> spheres = randomSpheres(200, 21);
  const SphereTree tree(spheres);
  for (const SphereTreeNode& node : tree.nodes()) {
    std::vector<Sphere> group;
    for (std::uint32_t i = 0; i < node.leafCount; ++i)
      group.push_back(spheres[tree.leaves()[node.firstLeaf + i]]);
    CHECK(node.radius == doctest::Approx(minimumEnclosingBall(group).radius).epsilon(1e-6));
    const double error = meanFreePart({node.center, node.radius}, group);
    CHECK(node.error == doctest::Approx(node.leafCount == 1 ? 0 : error).epsilon(1e-6));
  }
}

TEST_CASE("sphere trees over identical, nested, coplanar and geometrically spaced spheres") {
  const std::vector<Sphere> same(1000, Sphere{{1.1f, 2.2f, 3.3f}, 0.7f});
  const SphereTree tree(same);
  checkTree(tree, same);
  CHECK(levels(tree) <= 13);
  for (const SphereTreeNode& node : tree.nodes()) {
    CHECK(node.radius == 0.7f);
    CHECK(node.error < 1e-6f);
  }
  std::vector<Sphere> nested, plane, spaced;
  for (int i = 1; i <= 50; ++i) {
    nested.push_back({{0.01f * float(i), 0, 0}, 0.02f * float(i)});
    plane.push_back({{i % 7, 0, i / 7}, 0.5f});
    spaced.push_back({{std::ldexp(1.0f, i), 0, 0}, 1});
  }
  for (const auto& spheres : {nested, plane, spaced}) checkTree(SphereTree(spheres), spheres);
  CHECK(rootOf(nested).center == nested.back().center);
  CHECK(rootOf(nested).radius == nested.back().radius);
  CHECK(rootOf(nested).error < 1e-6f);
}

TEST_CASE("a sphere tree parts what lies apart") {
  std::vector<Sphere> spheres;  // 30 here, 70 there, mixed in the set
  for (int i = 0; i < 100; ++i)
    spheres.push_back({{i % 10 < 3 ? -1 : 1, 0.01f * float(i), 0.01f * float(i % 7)}, 0.1f});
  const SphereTree tree(spheres);
  const SphereTreeNode& first = tree.nodes()[1];
  REQUIRE((first.leafCount == 30 || first.leafCount == 70));
  for (std::uint32_t i = 0; i < 100; ++i)
    CHECK(spheres[tree.leaves()[i]].center.x == (i < 30 ? -1 : 1));
}

TEST_CASE("a refitted sphere tree follows its spheres") {
  const std::vector<Sphere> spheres = randomSpheres(1000, 12);
  const SphereTree built(spheres);
  SphereTree tree = built;
  const auto sumOfSquares = [](const SphereTree& any) {
    double sum = 0;
    for (const SphereTreeNode& node : any.nodes()) sum += double(node.radius) * node.radius;
    return sum;
  };
  tree.refit(spheres);
  checkTree(tree, spheres);
  CHECK(sumOfSquares(tree) >= sumOfSquares(built) * (1 - 1e-6));
  CHECK(sumOfSquares(tree) <= sumOfSquares(built) * 1.3);

  const std::vector<Sphere> moved = twisted(spheres);
  tree.refit(moved);
  checkTree(tree, moved);
  for (std::size_t i = 0; i < built.nodes().size(); ++i) {
    CHECK(tree.nodes()[i].leafCount == built.nodes()[i].leafCount);
    CHECK(tree.nodes()[i].error == built.nodes()[i].error);
  }
  CHECK_THROWS_AS(tree.refit(std::span(moved).first(999)), std::invalid_argument);
}

TEST_CASE("a sphere tree does not depend on the number of threads") {
  const std::vector<Sphere> spheres = randomSpheres(500, 13);
  setThreadCount(1);
  const SphereTree one(spheres);
  setThreadCount(5);
  const SphereTree five(spheres);
  setThreadCount(0);
  CHECK(std::memcmp(one.nodes().data(), five.nodes().data(), one.nodes().size_bytes()) == 0);
  CHECK(std::equal(one.leaves().begin(), one.leaves().end(), five.leaves().begin()));
}
