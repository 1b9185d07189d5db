#include "sh/quadrature.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

using namespace haarlight;

namespace {

constexpr double pi = std::numbers::pi;

template <typename Function>
double integrate(const SphereRule& rule, const Function& f) {
  double sum = 0;
  for (const auto& [direction, weight] : rule) sum += weight * f(direction);
  return sum;
}

double doubleFactorial(int n) {
  return n <= 1 ? 1 : n * doubleFactorial(n - 2);
}

/// ∫ x^a y^b z^c dω over the sphere for even exponents.
double monomialIntegral(int a, int b, int c) {
  return 4 * pi * doubleFactorial(a - 1) * doubleFactorial(b - 1) * doubleFactorial(c - 1) /
         doubleFactorial(a + b + c + 1);
}

}  // namespace

TEST_CASE("Gauss–Legendre points integrate powers up to twice their number") {
  for (const int count : {1, 2, 3, 10, 31, 64}) {
    const GaussLegendreRule rule = gaussLegendre(count);
    for (int power = 0; power < 2 * count; ++power) {
      double sum = 0;
      for (int i = 0; i < count; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
      REQUIRE(std::abs(sum - (power % 2 ? 0 : 2.0 / (power + 1))) < 1e-13);
    }
    for (int i = 1; i < count; ++i) REQUIRE(rule.nodes[i] > rule.nodes[i - 1]);
  }
}

TEST_CASE("a product rule integrates the polynomials of its degree") {
  for (const int degree : {0, 1, 2, 7, 12}) {
    const SphereRule rule = productRule(degree);
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) {
        const int c = degree - a - b;
        const double expected = a % 2 || b % 2 || c % 2 ? 0 : monomialIntegral(a, b, c);
        const double sum = integrate(rule, [&](const glm::dvec3& d) {
          return std::pow(d.x, a) * std::pow(d.y, b) * std::pow(d.z, c);
        });
        REQUIRE(std::abs(sum - expected) < 1e-13);
      }
  }
}

TEST_CASE("stratified directions are unit vectors, one in each cell of equal solid angle") {
  constexpr int cells = 20;
  const SphereRule rule = stratifiedSphere(cells, 7);
  REQUIRE(rule.size() == cells * cells);
  CHECK(integrate(rule, [](const glm::dvec3&) { return 1; }) == doctest::Approx(4 * pi));
  std::vector<int> hits(cells * cells);
  for (const auto& [d, weight] : rule) {
    REQUIRE(std::abs(glm::length(d) - 1) < 1e-14);
    const double azimuth = std::atan2(d.y, d.x) / (2 * pi);
    const int row = int((1 - d.z) / 2 * cells);
    const int column = int((azimuth < 0 ? azimuth + 1 : azimuth) * cells);
    ++hits[row * cells + column];
  }
  for (const int count : hits) REQUIRE(count == 1);
}

TEST_CASE("a seed gives the same directions again, another seed others") {
  CHECK(stratifiedSphere(5, 1)[12].direction == stratifiedSphere(5, 1)[12].direction);
  CHECK(stratifiedSphere(5, 1)[12].direction != stratifiedSphere(5, 2)[12].direction);
}

TEST_CASE("rules without points are refused") {
  CHECK_THROWS_AS(gaussLegendre(0), std::invalid_argument);
  CHECK_THROWS_AS(productRule(3, 0), std::invalid_argument);
  CHECK_THROWS_AS(productRule(-2), std::invalid_argument);
  CHECK_THROWS_AS(stratifiedSphere(0, 1), std::invalid_argument);
}
