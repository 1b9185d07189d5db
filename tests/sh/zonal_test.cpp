#include "sh/zonal.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "sh/projection.h"
#include "sh/random_functions.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("the clamped cosine's closed form is its projection, for any degree") {
  const auto closed = clampedCosineZonal(40);
  const auto projected = projectZonal(
      40, [](double z) { return z; }, 0, 1);
  for (int l = 0; l < 40; ++l) REQUIRE(std::abs(closed[l] - projected[l]) < 1e-13);
}

TEST_CASE("the clamped cosine's first coefficients are those of Ramamoorthi and Hanrahan") {
  const auto factors = convolutionFactors(clampedCosineZonal(7));
  const double pi = std::numbers::pi;
  const double expected[] = {pi, 2 * pi / 3, pi / 4, 0, -pi / 24, 0, pi / 64};
  for (int l = 0; l < 7; ++l) CHECK(factors[l] == doctest::Approx(expected[l]).epsilon(1e-14));
}

TEST_CASE("a turned zonal function is g(ω·axis)") {
  std::mt19937 random(1);
  const auto g = [](double cosine) { return 1 - 2 * cosine + 3 * cosine * cosine * cosine; };
  const auto zonal = projectZonal(4, g);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 axis = randomDirection(random), d = randomDirection(random);
    REQUIRE(std::abs(evaluate(rotateZonal(zonal, axis), d) - g(glm::dot(axis, d))) < 1e-13);
  }
}

TEST_CASE("convolution with the clamped cosine is irradiance") {
  std::mt19937 random(2);
  const auto light = randomFunction(6, random);
  const auto irradiance = scaleBands(light, convolutionFactors(clampedCosineZonal(6)));
  const glm::dvec3 normal = randomDirection(random);
  const ShVector<double> lobe = rotateZonal(clampedCosineZonal(6), normal);
  CHECK(evaluate(irradiance, normal) == doctest::Approx(dot(light, lobe)).epsilon(1e-13));
  // Against the integral itself: 400 × 800 points leave the kink at the horizon 1e-5.
  double sum = 0;
  for (const auto& [d, weight] : productRule(400, 800))
    sum += weight * evaluate(light, d) * std::fmax(0, glm::dot(normal, d));
  CHECK(std::abs(evaluate(irradiance, normal) - sum) < 1e-4);
}

TEST_CASE("wrong orders are refused") {
  CHECK_THROWS_AS(clampedCosineZonal(0), std::invalid_argument);
  CHECK_THROWS_AS(rotateZonal({}, {0, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(projectZonal(0, [](double z) { return z; }), std::invalid_argument);
}
