#include "sh/conventions.h"

#include <doctest/doctest.h>

#include "sh/random_functions.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("without the Condon–Shortley sign band 1 is y, z, x") {
  std::mt19937 random(1);
  const auto f = randomFunction(2, random);
  const auto unsigned_ = flipCondonShortley(f);
  const glm::dvec3 d = randomDirection(random);
  const double linear = std::sqrt(0.75 / std::acos(-1.0));
  const double value = unsigned_[0] * 0.5 / std::sqrt(std::acos(-1.0)) +
                       linear * (unsigned_[1] * d.y + unsigned_[2] * d.z + unsigned_[3] * d.x);
  CHECK(value == doctest::Approx(evaluate(f, d)).epsilon(1e-14));
}

TEST_CASE("adding and taking away the sign is exact") {
  std::mt19937 random(2);
  const auto f = randomFunction(9, random);
  CHECK(flipCondonShortley(flipCondonShortley(f)) == f);
  CHECK(flipCondonShortley(f).at(3, 2) == f.at(3, 2));
  CHECK(flipCondonShortley(f).at(3, -1) == -f.at(3, -1));
}

TEST_CASE("a function of a y-up world has the same values in a z-up world") {
  std::mt19937 random(3);
  const auto f = randomFunction(10, random);
  const auto g = yUpToZUp(f);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 d = randomDirection(random);
    REQUIRE(std::abs(evaluate(g, {d.x, -d.z, d.y}) - evaluate(f, d)) < 1e-12);
  }
  CHECK(largestDifference(zUpToYUp(g), f) < 1e-13);
}

TEST_CASE("a basis about the y axis is turned to one about the z axis") {
  std::mt19937 random(4);
  const auto f = randomFunction(10, random);
  const auto g = polarYToPolarZ(f);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 d = randomDirection(random);
    const double withPolarY = evaluate(f, {d.z, d.x, d.y});
    REQUIRE(std::abs(evaluate(g, d) - withPolarY) < 1e-12);
  }
  CHECK(largestDifference(polarZToPolarY(g), f) < 1e-13);
}
