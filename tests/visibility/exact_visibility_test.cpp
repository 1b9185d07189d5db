#include "visibility/exact_visibility.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace haarlight;

TEST_CASE("a texel is blocked iff the ray through its centre meets the sphere") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int i = 0; i < 30; ++i) {
    const glm::dvec3 center(2 * uniform(random), 2 * uniform(random), 2 * uniform(random));
    const double radius = 0.05 + 0.9 * std::abs(uniform(random)) * glm::length(center);
    BitCube cube;
    addSphereExactly(cube, center, radius);
    for (int texel = 0; texel < texelCount; ++texel) {
      const glm::dvec3 d = texelDirection(texel);
      const double along = glm::dot(center, d);  // nearest point of the ray, if ahead
      const double nearest = glm::length(center - std::max(0.0, along) * d);
      if (std::abs(nearest - radius) < 1e-12) continue;
      REQUIRE(cube.blocked(texel) == (nearest < radius));
    }
  }
}

TEST_CASE("spheres are merged by union") {
  const Sphere spheres[] = {{{0, 2, 0}, 0.5f}, {{3, 0, 0}, 1.0f}};
  BitCube expected;
  addSphereExactly(expected, {0, 2, 0}, 0.5);
  addSphereExactly(expected, {3, 0, 0}, 1.0);
  CHECK(exactBitCube(spheres, {0, 0, 0}) == expected);
}

TEST_CASE("a sample at the very centre of a sphere sees everything") {
  BitCube cube;
  addSphereExactly(cube, {0, 0, 0}, 1);
  CHECK(cube == BitCube{});
}
