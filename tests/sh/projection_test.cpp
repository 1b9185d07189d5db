#include "sh/projection.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sh/random_functions.h"
#include "sh/zonal.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double pi = std::numbers::pi;

/// The tutorial's two lights, max(0, 5 cos θ − 4) + max(0, −4 sin(θ − π) cos(φ − 2.5) − 3).
double twoLights(const glm::dvec3& d) {
  const double toSecond = d.x * std::cos(2.5) + d.y * std::sin(2.5);
  return std::fmax(0, 5 * d.z - 4) + std::fmax(0, 4 * toSecond - 3);
}

/// What the tutorial's author printed, from 10,000 random samples.
constexpr std::array<double, 16> printed{
    0.398787,                                                 //
    -0.210511, 0.286563,    0.281813,                         //
    -0.315004, -1.0256e-5,  0.131397, 9.08118e-5, 0.0931611,  //
    -0.249618, -8.40392e-5, 0.123395, 0.303834,   -0.165057, 3.75637e-5, -0.092273};

/// Each light is zonal about its direction and linear where it shines, so its coefficients are
/// polynomials' integrals: exact.
ShVector<double> exactCoefficients() {
  const auto first = projectZonal(
      4, [](double z) { return 5 * z - 4; }, 0.8, 1);
  const auto second = projectZonal(
      4, [](double z) { return 4 * z - 3; }, 0.75, 1);
  return rotateZonal(first, {0, 0, 1}) + rotateZonal(second, {std::cos(2.5), std::sin(2.5), 0});
}

/// 2000 × 4000 midpoints in θ and φ with weight sin θ, by the formula as printed.
ShVector<double> midpointCoefficients() {
  ShVector<double> sum(4), basis(4);
  for (int i = 0; i < 2000; ++i) {
    const double theta = pi * (i + 0.5) / 2000;
    for (int k = 0; k < 4000; ++k) {
      const double phi = 2 * pi * (k + 0.5) / 4000;
      const double value = std::fmax(0, 5 * std::cos(theta) - 4) +
                           std::fmax(0, -4 * std::sin(theta - pi) * std::cos(phi - 2.5) - 3);
      if (value == 0) continue;
      const glm::dvec3 direction(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                 std::cos(theta));
      evaluateShBasis<double>(4, direction, basis.coefficients());
      sum += basis * (value * std::sin(theta) * pi / 2000 * 2 * pi / 4000);
    }
  }
  return sum;
}

/// Standard error of each coefficient as the variance of 10,000 samples of f y gives it: that of
/// independent samples. Stratified ones do better.
ShVector<double> standardErrors() {
  const SphereRule samples = stratifiedSphere(100, 1);
  ShVector<double> sums(4), squares(4), basis(4);
  for (const auto& [d, weight] : samples) {
    evaluateShBasis<double>(4, d, basis.coefficients());
    for (int i = 0; i < 16; ++i) {
      const double value = 4 * pi * twoLights(d) * basis[i];
      sums[i] += value / samples.size();
      squares[i] += value * value / samples.size();
    }
  }
  for (int i = 0; i < 16; ++i)
    squares[i] = std::sqrt((squares[i] - sums[i] * sums[i]) / samples.size());
  return squares;
}

}  // namespace

TEST_CASE("the tutorial's function by 2000 × 4000 quadrature has its exact coefficients") {
  const auto exact = exactCoefficients();
  CHECK(largestDifference(midpointCoefficients(), exact) < 1e-6);
  const auto product = projectToSh(4, productRule(1000, 2000), twoLights);
  CHECK(largestDifference(product, exact) < 1e-6);
  for (int l = 0; l < 4; ++l)
    for (int m = -l; m <= l; ++m)
      MESSAGE("(", l, ", ", m, ") exact ", exact.at(l, m), ", printed ", printed[shIndex(l, m)]);
}

TEST_CASE("the tutorial's printed coefficients lie within its samples' error") {
  const auto exact = exactCoefficients();
  const auto errors = standardErrors();
  double largest = 0;
  for (int i = 0; i < 16; ++i)
    largest = std::fmax(largest, std::abs(printed[i] - exact[i]) / errors[i]);
  MESSAGE("largest deviation ", largest, " standard errors of independent samples");
  CHECK(largest < 3);
  // And much closer to the truth than that.
  for (int i = 0; i < 16; ++i) CHECK(std::abs(printed[i] - exact[i]) < 1e-4);
}

TEST_CASE("10,000 stratified samples lie within their own error") {
  const auto exact = exactCoefficients();
  const auto errors = standardErrors();
  constexpr int runs = 50;
  ShVector<double> squares(4), sums(4);
  for (int seed = 0; seed < runs; ++seed) {
    const auto sampled = projectToSh(4, stratifiedSphere(100, seed), twoLights);
    for (int i = 0; i < 16; ++i) {
      const double difference = sampled[i] - exact[i];
      REQUIRE(std::abs(difference) < 3 * errors[i]);
      squares[i] += difference * difference / runs;
      sums[i] += difference / runs;
    }
  }
  for (int i = 0; i < 16; ++i) {
    MESSAGE("coefficient ", i, ": standard error independent ", errors[i], ", stratified ",
            std::sqrt(squares[i]));
    CHECK(squares[i] < errors[i] * errors[i]);
    // Unbiased: the mean of the runs is off by its own error at most.
    CHECK(std::abs(sums[i]) < 4 * std::sqrt(squares[i] / runs));
  }
}

TEST_CASE("a band-limited function is projected exactly and reconstructed") {
  std::mt19937 random(1);
  for (const int order : {1, 3, 10, 20}) {
    const auto f = randomFunction(order, random);
    const auto projected = projectToSh(order, productRule(2 * (order - 1)),
                                       [&](const glm::dvec3& d) { return evaluate(f, d); });
    CHECK(largestDifference(projected, f) < 1e-13);
  }
}

TEST_CASE("more bands approach the tutorial's function") {
  const SphereRule rule = productRule(200, 400);
  double before = 1e9;
  for (const int order : {4, 5, 10, 12, 20}) {
    const auto f = projectToSh(order, rule, twoLights);
    double error = 0;
    for (const auto& [d, weight] : productRule(40, 80))
      error += weight * std::pow(evaluate(f, d) - twoLights(d), 2) / (4 * pi);
    MESSAGE(order, " bands: RMS error ", std::sqrt(error));
    CHECK(error < before);
    before = error;
  }
}

TEST_CASE("colours are projected channel by channel") {
  const SphereRule rule = productRule(6);
  const auto coloured =
      projectToSh(3, rule, [](const glm::dvec3& d) { return glm::dvec3(d.x, 1, d.y * d.z); });
  const auto green = projectToSh(3, rule, [](const glm::dvec3&) { return 1.0; });
  for (int i = 0; i < 9; ++i) CHECK(coloured[i].y == green[i]);
  CHECK(coloured.at(1, 1).x == doctest::Approx(-std::sqrt(4 * pi / 3)).epsilon(1e-14));
  CHECK(coloured.at(2, -1).z == doctest::Approx(-std::sqrt(4 * pi / 15)).epsilon(1e-14));
  CHECK_THROWS_AS(projectToSh(0, rule, twoLights), std::invalid_argument);
}
