#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "spheres/random_spheres.h"
#include "spheres/sphere_tree.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

using Query = std::function<bool(const glm::dvec3& center, double radius)>;

/// The spheres for which the query holds, and the number of nodes asked.
std::vector<std::uint32_t> found(const SphereTree& tree, const Query& query, std::size_t& asked) {
  std::vector<std::uint32_t> indices;
  tree.visit(
      [&](const SphereTreeNode& node) {
        ++asked;
        return query(node.center, node.radius);
      },
      [&](std::uint32_t index) { indices.push_back(index); });
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::vector<std::uint32_t> foundByAll(const std::vector<Sphere>& spheres, const Query& query) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < spheres.size(); ++i)
    if (query(spheres[i].center, spheres[i].radius)) indices.push_back(i);
  return indices;
}

Query meetsBall(const glm::dvec3& point, double size) {
  return [=](const glm::dvec3& center, double radius) {
    return glm::distance(center, point) <= radius + size;
  };
}

Query risesOverHorizon(const glm::dvec3& point, const glm::dvec3& normal) {
  return [=](const glm::dvec3& center, double radius) {
    return glm::dot(center - point, normal) + radius > 0;
  };
}

/// Balls that meet the cone of directions within `angle` around `axis`.
Query meetsCone(const glm::dvec3& apex, const glm::dvec3& axis, double angle) {
  return [=](const glm::dvec3& center, double radius) {
    const glm::dvec3 offset = center - apex;
    const double along = glm::dot(offset, axis), aside = glm::length(offset - along * axis);
    const bool apexIsNearest = along * std::cos(angle) + aside * std::sin(angle) < 0;
    return (apexIsNearest ? glm::length(offset)
                          : aside * std::cos(angle) - along * std::sin(angle)) <= radius;
  };
}

void checkQueries(const SphereTree& tree, const std::vector<Sphere>& spheres) {
  Random random(11);
  std::size_t asked = 0, hits = 0;
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 point = randomDirection(random) * (2 * random.uniform());
    const glm::dvec3 direction = randomDirection(random);
    for (const Query& query :
         {meetsBall(point, 0.2 * random.uniform()), risesOverHorizon(2.0 * point, direction),
          meetsCone(point, direction, 0.4 * random.uniform())}) {
      const std::vector<std::uint32_t> expected = foundByAll(spheres, query);
      CHECK(found(tree, query, asked) == expected);
      hits += expected.size();
    }
  }
  CHECK(hits > 0);
  CHECK(asked < 180 * spheres.size());  // each sphere on its own
}

bool blocks(const std::vector<Sphere>& spheres, const glm::dvec3& from, const glm::dvec3& towards) {
  return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
    const glm::dvec3 offset = glm::dvec3(sphere.center) - from;
    return glm::dot(offset, towards) > 0 &&
           glm::length(glm::cross(offset, towards)) < sphere.radius;
  });
}

}  // namespace

TEST_CASE("a sphere tree finds what a search through all spheres finds") {
  const std::vector<Sphere> spheres = randomSpheres(1500, 9), moved = twisted(spheres);
  SphereTree tree(spheres);
  checkQueries(tree, spheres);
  tree.refit(moved);
  checkQueries(tree, moved);
}

TEST_CASE("a node may stand for its group where it blocks little wrongly") {
  const std::vector<Sphere> spheres = randomSpheres(200, 4);
  const SphereTree tree(spheres);
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 receiver(randomDirection(random) * (4 * random.uniform()));
    for (const double maximumError : {0.0, 1e-5, 1e-3, 0.1, 0.6}) {
      int wrong = 0;
      for (const SphereTreeNode& node : tree.nodes()) {
        const double sine =
            double(node.radius) / glm::distance(glm::dvec3(node.center), glm::dvec3(receiver));
        const double blockedWrongly = node.error * (1 - std::sqrt(1 - sine * sine)) / 2;
        const bool expected = node.leafCount == 1 || (sine < 1 && blockedWrongly <= maximumError);
        wrong += mayStandForGroup(node, receiver, maximumError) != expected;
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("a cut of a sphere tree blocks what the spheres block and little more") {
  const std::vector<Sphere> spheres = randomSpheres(300, 8);
  const SphereTree tree(spheres);
  CHECK(tree.cut({9, 9, 9}, 1).size() == 1);
  for (const Sphere& ball : tree.cut({9, 9, 9}, 0))  // without error, a ball is one of its spheres
    CHECK(std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
      return sphere.center == ball.center && sphere.radius == ball.radius;
    }));
  Random random(2);
  for (const float distance : {1.5f, 3.0f, 10.0f}) {
    const double maximumError = 1.0 / 6144;
    const glm::vec3 receiver(glm::dvec3(distance) * randomDirection(random));
    const std::vector<Sphere> balls = tree.cut(receiver, maximumError);
    CHECK(balls.size() < spheres.size());
    const int samples = 20000;
    int wrong = 0, missed = 0;
    for (int i = 0; i < samples; ++i) {
      const glm::dvec3 direction = randomDirection(random);
      const bool blocked = blocks(spheres, receiver, direction);
      const bool cutBlocks = blocks(balls, receiver, direction);
      wrong += cutBlocks && !blocked;
      missed += blocked && !cutBlocks;
    }
    CHECK(missed == 0);
    CHECK(double(wrong) / samples <= double(balls.size()) * maximumError);
  }
}
