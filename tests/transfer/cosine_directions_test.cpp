#include "transfer/cosine_directions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "mesh/random.h"
#include "sh/zonal.h"

using namespace haarlight;

namespace {

glm::vec3 randomUnit(Random& random) {
  const double z = 2 * random.uniform() - 1, angle = 2 * std::numbers::pi * random.uniform();
  const double s = std::sqrt(1 - z * z);
  return glm::vec3(s * std::cos(angle), s * std::sin(angle), z);
}

constexpr int order = 5;

/// Means of the basis over the directions about an axis.
ShVector<double> meanBasis(const CosineDirections& set, const glm::vec3& axis, Random& random) {
  std::vector<glm::vec3> directions(set.count());
  set.about(axis, float(random.uniform()), float(random.uniform()), directions);
  ShVector<double> sum(order), basis(order);
  for (const glm::vec3& direction : directions) {
    evaluateShBasis<double>(order, glm::dvec3(direction), basis.coefficients());
    sum += basis;
  }
  return sum * (1.0 / set.count());
}

ShVector<double> expectedMean(const glm::vec3& axis) {
  return rotateZonal(clampedCosineZonal(order), glm::dvec3(axis)) * (1 / std::numbers::pi);
}

}  // namespace

TEST_CASE("directions are unit and lie over the hemisphere of any axis") {
  Random random(1);
  const CosineDirections set(100);
  std::vector<glm::vec3> directions(100);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 axis = i == 0 ? glm::vec3(0, 0, -1) : randomUnit(random);
    set.about(axis, float(random.uniform()), float(random.uniform()), directions);
    for (const glm::vec3& direction : directions) {
      CHECK(glm::length(direction) == doctest::Approx(1).epsilon(1e-6));
      CHECK(glm::dot(direction, axis) > -1e-6f);
    }
  }
}

TEST_CASE("means over directions are cosine-weighted integrals, far better than random ones") {
  // Independent directions have variances of at most max y² / N; max y² of bands 0 to 4 is
  // 9/4π at the pole.
  Random random(2);
  for (const int count : {64, 1000, 4096}) {
    const CosineDirections set(count);
    double squared = 0;
    constexpr int axes = 100;
    for (int i = 0; i < axes; ++i) {
      const glm::vec3 axis = randomUnit(random);
      const ShVector<double> error = meanBasis(set, axis, random) - expectedMean(axis);
      squared += dot(error, error) / (axes * order * order);
    }
    const double independent = std::sqrt(1 / (4 * std::numbers::pi * count));  // mean of y² = 1/4π
    CAPTURE(count);
    MESSAGE(count, " directions: root mean square error ", std::sqrt(squared), ", independent ",
            independent);
    CHECK(std::sqrt(squared) < independent / 8);
  }
}

TEST_CASE("over turns and shifts a few directions have no bias") {
  Random random(3);
  const CosineDirections set(3);
  const glm::vec3 axis = randomUnit(random);
  constexpr int runs = 20000;
  ShVector<double> mean(order);
  for (int i = 0; i < runs; ++i) mean += meanBasis(set, axis, random) * (1.0 / runs);
  const ShVector<double> error = mean - expectedMean(axis);
  // The largest |y| of an order-5 basis is √(9/4π) = 0.85; 5 standard errors of as many runs.
  for (const double e : error.coefficients()) CHECK(std::abs(e) < 5 * 0.85 / std::sqrt(runs));
}

TEST_CASE("a set without directions is refused") {
  CHECK_THROWS_AS(CosineDirections(0), std::invalid_argument);
}
