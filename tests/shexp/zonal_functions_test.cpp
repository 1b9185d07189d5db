#include "shexp/zonal_functions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "sh/projection.h"
#include "sh/random_functions.h"
#include "sh/triple_tensor.h"
#include "sh/zonal.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double pi = std::numbers::pi;

/// RMS over the sphere of the difference of two zonal functions.
double distance(const std::vector<double>& f, const std::vector<double>& g) {
  double squares = 0;
  for (std::size_t l = 0; l < f.size(); ++l) squares += (f[l] - g[l]) * (f[l] - g[l]);
  return std::sqrt(squares / (4 * pi));
}

std::vector<double> exponentialOf(const std::vector<double>& f) {
  return zonalFunction(f, [](double x) { return std::exp(x); });
}

}  // namespace

TEST_CASE("the visibility past a sphere is its projection") {
  const double cosine = 0.6;
  const auto zonal = capVisibility(6, cosine);
  // Rows of the rule lie on both sides of the cap's edge, which therefore is the only error.
  const auto projected = projectToSh(
      6, productRule(4000, 12), [&](const glm::dvec3& d) { return d.z >= cosine ? 0.0 : 1.0; });
  for (int l = 0; l < 6; ++l) CHECK(std::abs(zonal[l] - projected.at(l, 0)) < 2e-3);
  CHECK(zonal[0] == doctest::Approx(0.5 / std::sqrt(pi) * (4 * pi - 2 * pi * (1 - cosine))));
}

TEST_CASE("a zonal function of a function: the identity, the square, a constant") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> zonal(6);
  for (double& coefficient : zonal) coefficient = value(random);
  CHECK(distance(zonalFunction(zonal, [](double x) { return x; }), zonal) < 1e-14);
  const auto constant = zonalFunction(zonal, [](double) { return 3.0; });
  CHECK(constant[0] == doctest::Approx(3 * std::sqrt(4 * pi)).epsilon(1e-13));
  for (int l = 1; l < 6; ++l) CHECK(std::abs(constant[l]) < 1e-13);
  const auto squared = square(rotateZonal(zonal, {0, 0, 1}));
  const auto byFunction = zonalFunction(zonal, [](double x) { return x * x; });
  for (int l = 0; l < 6; ++l) CHECK(std::abs(byFunction[l] - squared.at(l, 0)) < 1e-13);
}

TEST_CASE("the exponential of a zonal function is the general one") {
  const auto f = zonalLogarithm(capVisibility(5, std::cos(1.0)));
  const auto zonal = rotateZonal(exponentialOf(f), {0, 0, 1});
  CHECK(largestDifference(shExponential(rotateZonal(f, {0, 0, 1})), zonal) < 1e-12);
}

TEST_CASE("the exponential is the pointwise one while powers fit the order") {
  // f of order 2 and powers up to f⁷ fit order 8; the rest of the series is below 1e-9.
  std::mt19937 random(2);
  const auto f = (randomFunction(2, random) * 0.1).withOrder(8);
  const auto g = shExponential(f);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 d = randomDirection(random);
    REQUIRE(std::abs(evaluate(g, d) - std::exp(evaluate(f, d))) < 1e-8);
  }
}

TEST_CASE("the exponential grows by its own product: d/dt exp(t f) = f exp(t f)") {
  std::mt19937 random(3);
  const auto f = randomFunction(5, random);
  constexpr double step = 1e-4;
  const auto slope = (shExponential(f * (1 + step)) - shExponential(f * (1 - step))) * (0.5 / step);
  CHECK(largestDifference(slope, product(f, shExponential(f))) < 1e-6);
}

TEST_CASE("exp of a sphere's logarithm is its projected visibility") {
  // Nearly exact while no eigenvalue is cut off, within a few hundredths beyond.
  for (const int order : {4, 5, 6}) {
    double small = 0, large = 0;
    for (int degrees = 1; degrees <= 90; ++degrees) {
      const auto visibility = capVisibility(order, std::cos(degrees * pi / 180));
      const double error = distance(exponentialOf(zonalLogarithm(visibility)), visibility);
      double& largest = degrees <= 25 ? small : large;
      largest = std::fmax(largest, error);
    }
    MESSAGE("order ", order, ": up to 25 degrees ", small, ", up to 90 degrees ", large);
    CHECK(small < 1e-4);
    CHECK(large < 0.045);
  }
}
