#include "visibility/exact_visibility.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace haarlight;

TEST_CASE("a texel is blocked iff the ray through its centre meets the sphere") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 sample(uniform(random), uniform(random), uniform(random));
    const glm::vec3 toCenter(2 * uniform(random), 2 * uniform(random), 2 * uniform(random));
    const float radius = 0.9f * std::abs(uniform(random)) * glm::length(toCenter);
    BitCube cube;
    addSphereExactly(cube, {sample + toCenter, radius}, sample, glm::normalize(toCenter));
    const glm::dvec3 center = glm::dvec3(sample + toCenter) - glm::dvec3(sample);
    for (int texel = 0; texel < texelCount; ++texel) {
      const glm::dvec3 d = texelDirection(texel);
      const double along = glm::dot(center, d);  // nearest point of the ray, if ahead
      const double nearest = glm::length(center - std::max(0.0, along) * d);
      if (std::abs(nearest - radius) < 1e-5) continue;  // on the rim, within float32
      REQUIRE(cube.blocked(texel) == (nearest < radius));
    }
  }
}

TEST_CASE("spheres are merged by union") {
  const Sphere spheres[] = {{{0, 2, 0}, 0.5f}, {{3, 0, 0}, 1.0f}};
  BitCube expected;
  for (const Sphere& sphere : spheres) addSphereExactly(expected, sphere, {0, 0, 0}, {0, 1, 0});
  CHECK(exactBitCube(spheres, {0, 0, 0}, {0, 1, 0}) == expected);
}

TEST_CASE("a sample inside a sphere sees the side of the centre blocked, up to its horizon") {
  const glm::vec3 up(0, 1, 0);
  const BitCube above = exactBitCube(std::vector<Sphere>{{{0, 0.5f, 0}, 1}}, {0, 0, 0}, up);
  for (int texel = 0; texel < texelCount; ++texel)
    REQUIRE(above.blocked(texel) == (texelDirection(texel).y >= 0));
  const BitCube below = exactBitCube(std::vector<Sphere>{{{0, -0.5f, 0}, 1}}, {0, 0, 0}, up);
  CHECK(below == BitCube{});
}

TEST_CASE("below the tangent plane the cap shrinks to nothing at sin⁻¹ ¼") {
  const glm::vec3 up(0, 1, 0);
  const auto blockedTexels = [&](float sine) {
    const Sphere sphere{{std::sqrt(1 - sine * sine), sine, 0}, 0.95f};
    const BitCube cube = exactBitCube(std::span(&sphere, 1), {0, 0, 0}, up);
    int count = 0;
    for (int texel = 0; texel < texelCount; ++texel) count += cube.blocked(texel);
    return count;
  };
  CHECK(blockedTexels(0) == blockedTexels(-0.001f));
  CHECK(blockedTexels(-0.1f) > blockedTexels(-0.2f));
  CHECK(blockedTexels(-0.26f) == 0);
}
