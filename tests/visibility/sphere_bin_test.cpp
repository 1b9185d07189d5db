#include "visibility/sphere_bin.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

using namespace haarlight;

namespace {

glm::vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

}  // namespace

TEST_CASE("the direction bin is the texel the direction falls into") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> length(0.001f, 1000);
  int different = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::vec3 d = length(random) * randomDirection(random);
    different += directionBin(d) != texelAt(glm::dvec3(d));
  }
  CHECK(different <= 2);  // only on a texel's border, within a rounding of float32
}

TEST_CASE("directions on borders, edges and corners have the bin of the exact quotient") {
  // 16·s and 16·t of these are whole numbers, so the border itself is met exactly; it belongs to
  // the larger column.
  for (int column = 0; column < faceSize; ++column) {
    const float s = float(column - 16) / 16;
    CHECK(directionBin({s, 1, s}) == texelAt({s, 1, s}));
    CHECK(directionBin({s, -s, 1}) == texelAt({s, -s, 1}));
  }
  for (const float x : {-1.0f, 1.0f})
    for (const float y : {-1.0f, 1.0f})
      for (const float z : {-1.0f, 1.0f}) CHECK(directionBin({x, y, z}) == texelAt({x, y, z}));
}

TEST_CASE("scaling by a power of two changes no direction bin") {
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 d = randomDirection(random);
    CHECK(directionBin(d) == directionBin(d * 0x1p40f));
    CHECK(directionBin(d) == directionBin(d * 0x1p-40f));
  }
}

TEST_CASE("the radius bin holds r = sin α between its bounds") {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> ratio(0.0001f, 0.9999f), scale(0.01f, 100);
  for (int i = 0; i < 10000; ++i) {
    const float distance = scale(random), r = ratio(random);
    const glm::vec3 d = distance * randomDirection(random);
    const double trueRatio = double(distance * r) / glm::length(glm::dvec3(d));
    const int bin = radiusBin(d, distance * r, glm::normalize(d));
    CHECK(trueRatio >= std::pow(bin / 32.0, 1.5) * (1 - 1e-6));
    CHECK(trueRatio <= std::pow((bin + 1) / 32.0, 1.5) * (1 + 1e-6));
  }
}

TEST_CASE("a sample inside a sphere sees a hemisphere when the centre is above its horizon") {
  const glm::vec3 up(0, 1, 0);
  CHECK(radiusBin({0, 0.01f, 0}, 1, up) == radiusBins - 1);
  CHECK(radiusBin({0.5f, 0, 0}, 1, up) == radiusBins - 1);
  CHECK(radiusBin({0, 0, 0}, 1, up) == radiusBins - 1);
}

TEST_CASE("below the horizon r'² is at most 1 − 16 (v·n)²") {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> sine(-0.25f, 0);
  const glm::vec3 up(0, 1, 0);
  for (int i = 0; i < 1000; ++i) {
    const double s = sine(random), limit = std::sqrt(1 - 16 * s * s);
    const glm::vec3 d(3 * std::sqrt(1 - s * s), 3 * s, 0);
    const int bin = radiusBin(d, 10, up);
    CHECK(limit >= std::pow(bin / 32.0, 1.5) - 1e-5);
    CHECK(limit <= std::pow((bin + 1) / 32.0, 1.5) + 1e-5);
    CHECK(radiusBin(d, 0.03f, up) == std::min(bin, radiusBin(d, 0.03f, glm::vec3(0, -1, 0))));
  }
  CHECK(radiusBin({0, -1, 0}, 10, up) == 0);
}

TEST_CASE("huge, tiny and non-finite distances still give an entry of the table") {
  const float values[] = {0,
                          1e-45f,
                          1e-38f,
                          1e-20f,
                          1e20f,
                          3e38f,
                          std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()};
  for (const float x : values)
    for (const float radius : {1e-30f, 1.0f, 1e30f}) {
      const int entry = sphereTableEntry({{x, 0, -x}, radius}, {0, 0, 0}, {0, 1, 0});
      CHECK(entry >= 0);
      CHECK(entry < texelCount * radiusBins);
    }
}
