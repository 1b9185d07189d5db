#include "sh/triple_tensor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "sh/projection.h"
#include "sh/random_functions.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// T_ijk of an order for all i, j, k, by the product rule that is exact for them.
std::vector<double> tensorByQuadrature(int order) {
  const int count = shCoefficientCount(order);
  std::vector<double> tensor(count * count * count);
  std::vector<double> basis(count);
  for (const auto& [direction, weight] : productRule(3 * (order - 1))) {
    evaluateShBasis<double>(order, direction, basis);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        for (int k = 0; k < count; ++k)
          tensor[(i * count + j) * count + k] += weight * basis[i] * basis[j] * basis[k];
  }
  return tensor;
}

}  // namespace

TEST_CASE("every triple coefficient is the integral, in all six orders of its indices") {
  for (const int order : {1, 2, 3, 6}) {
    const int count = shCoefficientCount(order);
    const auto expected = tensorByQuadrature(order);
    const ShTripleTensor tensor(order);
    double error = 0;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        for (int k = 0; k < count; ++k)
          error = std::fmax(error,
                            std::abs(tensor.at(i, j, k) - expected[(i * count + j) * count + k]));
    MESSAGE("order ", order, ": ", tensor.entries().size(), " entries, largest error ", error);
    CHECK(error < 1e-14);
  }
}

TEST_CASE("only what differs from 0 is stored, once and sorted") {
  for (const int order : {4, 5, 6, 10}) {
    const auto& entries = ShTripleTensor::shared(order).entries();
    double smallest = 1;
    std::array<int, 3> before{-1, -1, -1};
    for (const auto& [i, j, k, value] : entries) {
      smallest = std::min(smallest, std::abs(value));
      const std::array index{i, j, k};
      REQUIRE(before < index);
      REQUIRE(i <= j);
      REQUIRE(j <= k);
      before = index;
    }
    MESSAGE("order ", order, ": ", entries.size(), " entries, the smallest ", smallest);
    CHECK(smallest > 1e-6);
  }
}

TEST_CASE("the product is the pointwise product where the order suffices") {
  std::mt19937 random(1);
  const auto f = randomFunction(5, random), g = randomFunction(4, random);
  const auto whole = product(f.withOrder(8), g.withOrder(8));
  const auto squared = square(f.withOrder(9));
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 d = randomDirection(random);
    REQUIRE(std::abs(evaluate(whole, d) - evaluate(f, d) * evaluate(g, d)) < 1e-12);
    REQUIRE(std::abs(evaluate(squared, d) - evaluate(f, d) * evaluate(f, d)) < 1e-12);
  }
}

TEST_CASE("a product of the same order is the pointwise product's projection") {
  std::mt19937 random(2);
  for (const int order : {1, 4, 7}) {
    const auto f = randomFunction(order, random), g = randomFunction(order, random);
    const auto expected =
        projectToSh(order, productRule(3 * (order - 1)),
                    [&](const glm::dvec3& d) { return evaluate(f, d) * evaluate(g, d); });
    CHECK(largestDifference(product(f, g), expected) < 1e-12);
    CHECK(largestDifference(product(g, f), expected) < 1e-12);
    CHECK(largestDifference(square(f), product(f, f)) < 1e-13);
  }
}

TEST_CASE("the transfer matrix of b multiplies by b, and is symmetric") {
  std::mt19937 random(3);
  const auto b = randomFunction(6, random), f = randomFunction(6, random);
  const ShTransferMatrix matrix(b);
  CHECK(largestDifference(matrix(f), product(f, b)) < 1e-13);
  for (int i = 0; i < f.size(); ++i)
    for (int j = 0; j < f.size(); ++j) REQUIRE(matrix.at(i, j) == matrix.at(j, i));
}

TEST_CASE("the tutorial's example, b = y_5: the matrix is the tensor's slice") {
  // Its figure shows the entries of a 25 × 25 matrix that are not 0.
  ShVector<double> b(5);
  b[5] = 1;
  const ShTransferMatrix matrix(b);
  const auto expected = tensorByQuadrature(5);
  for (int i = 0; i < 25; ++i)
    for (int j = 0; j < 25; ++j)
      REQUIRE(std::abs(matrix.at(i, j) - expected[(i * 25 + j) * 25 + 5]) < 1e-14);
}

TEST_CASE("double and triple integrals are those of the functions") {
  std::mt19937 random(4);
  const auto f = randomFunction(5, random), g = randomFunction(5, random),
             h = randomFunction(5, random);
  double twofold = 0, threefold = 0;
  for (const auto& [d, weight] : productRule(12)) {
    twofold += weight * evaluate(f, d) * evaluate(g, d);
    threefold += weight * evaluate(f, d) * evaluate(g, d) * evaluate(h, d);
  }
  CHECK(dot(f, g) == doctest::Approx(twofold).epsilon(1e-12));
  CHECK(tripleIntegral(f, g, h) == doctest::Approx(threefold).epsilon(1e-12));
}

TEST_CASE("multiplying by a constant 1 changes nothing, in colour too") {
  ShVector<float> one(4);
  one[0] = float(std::sqrt(4 * std::acos(-1.0)));
  ShVector<glm::vec3> light(4);
  for (int i = 0; i < light.size(); ++i) light[i] = glm::vec3(i, 1, -i);
  const auto same = product(light, one);
  for (int i = 0; i < light.size(); ++i) CHECK(glm::length(same[i] - light[i]) < 1e-5f);
}

TEST_CASE("functions of different orders are refused") {
  const ShVector<double> f(3), g(4);
  CHECK_THROWS_AS(product(f, g), std::invalid_argument);
  CHECK_THROWS_AS(ShTransferMatrix{f}(g), std::invalid_argument);
  CHECK_THROWS_AS(tripleIntegral(f, f, g), std::invalid_argument);
  CHECK_THROWS_AS(ShTripleTensor(0), std::invalid_argument);
}
