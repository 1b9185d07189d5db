#include "sh/basis.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "sh/quadrature.h"
#include "sh/random_functions.h"

using namespace haarlight;
using haarlight::test::randomDirection;

namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

/// The tutorial's P(l, m, x), word for word but in extended precision.
long double legendre(int l, int m, long double x) {
  long double pmm = 1;
  const long double sine = std::sqrt((1 - x) * (1 + x));
  for (int i = 1; i <= m; ++i) pmm *= -(2 * i - 1) * sine;
  if (l == m) return pmm;
  long double above = x * (2 * m + 1) * pmm;
  for (int ll = m + 2; ll <= l; ++ll) {
    const long double next = ((2 * ll - 1) * x * above - (ll + m - 1) * pmm) / (ll - m);
    pmm = above;
    above = next;
  }
  return above;
}

/// The tutorial's SH(l, m, θ, φ): factorials and angles.
double tutorialBasis(int l, int m, const glm::dvec3& direction) {
  const int size = std::abs(m);
  const long double norm = (2 * l + 1) / (4 * pi) *
                           std::tgamma(static_cast<long double>(l - size + 1)) /
                           std::tgamma(static_cast<long double>(l + size + 1));
  const long double polar = std::sqrt(norm) * legendre(l, size, direction.z);
  const long double azimuth = std::atan2(static_cast<long double>(direction.y), direction.x);
  if (m == 0) return double(polar);
  return double(std::sqrt(2.0L) * polar *
                (m > 0 ? std::cos(m * azimuth) : std::sin(size * azimuth)));
}

template <typename Real>
std::vector<Real> basisAt(int order, const glm::vec<3, Real>& direction) {
  std::vector<Real> values(shCoefficientCount(order));
  evaluateShBasis<Real>(order, direction, values);
  return values;
}

/// Largest |∫ y_i y_j dω − δ_ij| by a product rule that is exact for the products.
template <typename Real>
double orthonormalityError(int order) {
  const int count = shCoefficientCount(order);
  std::vector<double> gram(count * count);
  for (const auto& [direction, weight] : productRule(2 * (order - 1))) {
    const auto basis = basisAt<Real>(order, glm::vec<3, Real>(direction));
    for (int i = 0; i < count; ++i)
      for (int j = 0; j <= i; ++j) gram[i * count + j] += weight * basis[i] * basis[j];
  }
  double error = 0;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j <= i; ++j) error = std::fmax(error, std::abs(gram[i * count + j] - (i == j)));
  return error;
}

}  // namespace

TEST_CASE("indices count bands and m") {
  CHECK(shIndex(0, 0) == 0);
  CHECK(shIndex(1, -1) == 1);
  CHECK(shIndex(3, 3) == shCoefficientCount(4) - 1);
  for (int l = 0; l < 20; ++l)
    for (int m = -l; m <= l; ++m) REQUIRE(shDegree(shIndex(l, m)) == l);
}

TEST_CASE("the first three bands are their closed forms in x, y, z") {
  std::mt19937 random(1);
  const double one = 0.5 * std::sqrt(1 / std::numbers::pi);
  const double linear = std::sqrt(0.75 / std::numbers::pi);
  const double mixed = 0.5 * std::sqrt(15 / std::numbers::pi);
  const double axial = 0.25 * std::sqrt(5 / std::numbers::pi);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 d = randomDirection(random);
    const double expected[] = {one,
                               -linear * d.y,
                               linear * d.z,
                               -linear * d.x,
                               mixed * d.x * d.y,
                               -mixed * d.y * d.z,
                               axial * (3 * d.z * d.z - 1),
                               -mixed * d.x * d.z,
                               mixed / 2 * (d.x * d.x - d.y * d.y)};
    const auto values = basisAt<double>(3, d);
    for (int k = 0; k < 9; ++k) REQUIRE(std::abs(values[k] - expected[k]) < 1e-15);
  }
}

TEST_CASE("values are the tutorial's, at the poles too") {
  std::mt19937 random(2);
  std::vector<glm::dvec3> directions{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
  for (int i = 0; i < 200; ++i) directions.push_back(randomDirection(random));
  double error = 0, singleError = 0;
  for (const glm::dvec3& direction : directions) {
    const auto values = basisAt<double>(20, direction);
    const auto single = basisAt<float>(20, glm::vec3(direction));
    // Rounding a direction moves it, so single precision is judged at the rounded one.
    const glm::dvec3 rounded = glm::normalize(glm::dvec3(glm::vec3(direction)));
    for (int l = 0; l < 20; ++l)
      for (int m = -l; m <= l; ++m) {
        const int i = shIndex(l, m);
        error = std::fmax(error, std::abs(values[i] - tutorialBasis(l, m, direction)));
        singleError = std::fmax(singleError, std::abs(single[i] - tutorialBasis(l, m, rounded)));
      }
  }
  MESSAGE("order 20, largest error: double ", error, ", float ", singleError);
  CHECK(error < 1e-13);
  CHECK(singleError < 2e-5);
}

TEST_CASE("the basis is orthonormal up to order 20, in double and in float") {
  for (const int order : {1, 2, 5, 10, 15, 20}) {
    const double error = orthonormalityError<double>(order);
    const double singleError = orthonormalityError<float>(order);
    MESSAGE("order ", order, ": double ", error, ", float ", singleError);
    CHECK(error < 1e-13);
    CHECK(singleError < (order <= 15 ? 1e-6 : 2e-6));
  }
}

TEST_CASE("addition theorem: the sum over m of y(a) y(b) is (2l + 1)/4π P_l(a·b)") {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 a = randomDirection(random), b = randomDirection(random);
    const auto atA = basisAt<double>(20, a), atB = basisAt<double>(20, b);
    for (int l = 0; l < 20; ++l) {
      double sum = 0;
      for (int m = -l; m <= l; ++m) sum += atA[shIndex(l, m)] * atB[shIndex(l, m)];
      const double expected =
          double((2 * l + 1) / (4 * pi) * std::legendre(unsigned(l), glm::dot(a, b)));
      REQUIRE(std::abs(sum - expected) < 1e-13);
    }
  }
}

TEST_CASE("the largest order is finite and keeps the addition theorem at a = b") {
  std::mt19937 random(4);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 direction = i == 0 ? glm::dvec3(0, 0, 1) : randomDirection(random);
    const auto values = basisAt<double>(maximumShOrder, direction);
    const auto single = basisAt<float>(maximumShOrder, glm::vec3(direction));
    double sum = 0, singleSum = 0;
    for (const double value : values) sum += value * value;
    for (const float value : single) singleSum += double(value) * value;
    const double expected = double(shCoefficientCount(maximumShOrder) / (4 * pi));
    CHECK(sum == doctest::Approx(expected).epsilon(1e-12));
    CHECK(singleSum == doctest::Approx(expected).epsilon(1e-4));
  }
}

TEST_CASE("the zonal functions are those with m = 0") {
  std::mt19937 random(5);
  const glm::dvec3 direction = randomDirection(random);
  const auto values = basisAt<double>(12, direction);
  std::vector<double> zonal(12);
  evaluateZonalBasis(direction.z, zonal);
  for (int l = 0; l < 12; ++l) CHECK(zonal[l] == values[shIndex(l, 0)]);
}

TEST_CASE("wrong orders and sizes are refused") {
  std::vector<double> values(9);
  const glm::dvec3 up(0, 0, 1);
  CHECK_THROWS_AS(evaluateShBasis<double>(0, up, {}), std::invalid_argument);
  CHECK_THROWS_AS(evaluateShBasis<double>(maximumShOrder + 1, up, values), std::invalid_argument);
  CHECK_THROWS_AS(evaluateShBasis<double>(2, up, values), std::invalid_argument);
  CHECK_THROWS_AS(evaluateZonalBasis(1, {}), std::invalid_argument);
}
