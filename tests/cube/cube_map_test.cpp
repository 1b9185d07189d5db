#include "cube/cube_map.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

using namespace haarlight;

namespace {

constexpr double pi = std::numbers::pi;

int texelIndex(int face, int row, int column) {
  return (face * faceSize + row) * faceSize + column;
}

}  // namespace

TEST_CASE("faces follow the OpenGL specification's table of sc, tc, ma") {
  // Columns of the table: the direction's component that gives s, and t, for each face.
  struct Row {
    glm::dvec3 major, s, t;
  };
  const Row table[] = {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                       {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                       {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
  for (int face = 0; face < faceCount; ++face) {
    const glm::dvec3 direction = cubeDirection({face, 0.25, -0.5});
    CHECK(glm::dot(direction, table[face].major) == 1.0);
    CHECK(glm::dot(direction, table[face].s) == 0.25);
    CHECK(glm::dot(direction, table[face].t) == -0.5);
  }
}

TEST_CASE("projecting a direction inverts cubeDirection") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-0.999, 0.999), scale(0.01, 100);
  for (int i = 0; i < 1000; ++i) {
    const FacePoint point{i % faceCount, coordinate(random), coordinate(random)};
    const FacePoint found = projectToCube(scale(random) * cubeDirection(point));
    CHECK(found.face == point.face);
    CHECK(found.s == doctest::Approx(point.s).epsilon(1e-12));
    CHECK(found.t == doctest::Approx(point.t).epsilon(1e-12));
  }
}

TEST_CASE("every texel's centre direction falls into the texel") {
  for (int texel = 0; texel < texelCount; ++texel) REQUIRE(texelAt(texelDirection(texel)) == texel);
}

TEST_CASE("row 0 of the side faces is the top") {
  CHECK(texelDirection(texelIndex(4, 0, 16)).y > 0.6);
  CHECK(texelDirection(texelIndex(4, 31, 16)).y < -0.6);
}

TEST_CASE("solid angles of all texels add up to the sphere's") {
  double sum = 0, largest = 0, smallest = 1;
  for (int texel = 0; texel < texelCount; ++texel) {
    const double solidAngle = texelSolidAngle(texel);
    sum += solidAngle;
    largest = std::max(largest, solidAngle);
    smallest = std::min(smallest, solidAngle);
  }
  CHECK(sum == doctest::Approx(4 * pi).epsilon(1e-12));
  // At a face's centre and corner: (1/16)² / d³ with d = 1 and √3, to the texel's size.
  CHECK(largest == doctest::Approx(1 / 256.0).epsilon(0.01));
  CHECK(smallest == doctest::Approx(1 / 256.0 / std::pow(3, 1.5)).epsilon(0.1));
}

TEST_CASE("a quarter of a face covers a quarter of a sixth of the sphere") {
  CHECK(faceRectangleSolidAngle(0, 1, 0, 1) == doctest::Approx(pi / 6).epsilon(1e-12));
}

TEST_CASE("a texel's first moment agrees with a fine numerical integral") {
  for (const int texel : {texelIndex(0, 0, 0), texelIndex(2, 15, 16), texelIndex(5, 31, 3)}) {
    const int row = texel / faceSize % faceSize, column = texel % faceSize;
    constexpr int n = 64;
    constexpr double cell = 2.0 / faceSize / n;
    glm::dvec3 integral(0);
    for (int i = 0; i < n * n; ++i) {
      const double s = 2.0 * column / faceSize - 1 + (i % n + 0.5) * cell;
      const double t = 2.0 * row / faceSize - 1 + (i / n + 0.5) * cell;
      const glm::dvec3 d = cubeDirection({texel / texelsPerFace, s, t});
      const double length = glm::length(d);
      integral += d / length * (cell * cell / (length * length * length));
    }
    CHECK(glm::length(texelMoment(texel) - integral) < 1e-6 * glm::length(integral));
  }
}

TEST_CASE("the hemisphere's cosine-weighted solid angle is π") {
  double sum = 0;
  for (int texel = 0; texel < texelCount; ++texel)
    sum += std::max(0.0, texelMoment(texel).y);  // the horizon y = 0 runs between texels
  CHECK(sum == doctest::Approx(pi).epsilon(1e-12));
}
