#include "sh/rotation.h"

#include <doctest/doctest.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

#include "sh/projection.h"
#include "sh/random_functions.h"
#include "sh/zonal.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

double norm(const ShVector<double>& f) {
  return std::sqrt(dot(f, f));
}

/// Smooth, without symmetry and not band-limited.
double smoothFunction(const glm::dvec3& d) {
  return std::exp(0.8 * d.x - 0.3 * d.y) + d.x * d.y * d.z + 0.5 * std::sin(2 * d.z + d.y);
}

}  // namespace

TEST_CASE("a function rotated, then projected is the function projected, then rotated") {
  // Both are projected by a rule that is exact, but for what a smooth function has above degree 24.
  constexpr int order = 10;
  const SphereRule rule = productRule(order + 24);
  const auto projected = projectToSh(order, rule, smoothFunction);
  std::mt19937 random(1);
  double largest = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dmat3 rotation = randomRotation(random), back = glm::transpose(rotation);
    const auto expected =
        projectToSh(order, rule, [&](const glm::dvec3& d) { return smoothFunction(back * d); });
    const auto rotated = ShRotation(rotation, order)(projected);
    largest = std::fmax(largest, norm(rotated - expected) / norm(expected));
  }
  MESSAGE("1,000 rotations, largest relative error ", largest);
  CHECK(largest < 1e-12);
}

TEST_CASE("values move with the rotation, at every order") {
  std::mt19937 random(2);
  double largest = 0;
  for (const int order : {1, 2, 3, 5, 15, 20, 32})
    for (int i = 0; i < 5; ++i) {
      const glm::dmat3 rotation = randomRotation(random);
      const auto f = randomFunction(order, random);
      const auto g = ShRotation(rotation, order)(f);
      for (int k = 0; k < 20; ++k) {
        const glm::dvec3 d = randomDirection(random);
        const double error = std::abs(evaluate(g, rotation * d) - evaluate(f, d)) / norm(f);
        largest = std::fmax(largest, error);
      }
    }
  MESSAGE("orders 1 to 32, largest error ", largest, " of the norm");
  CHECK(largest < 1e-11);
}

TEST_CASE("a rotation keeps each band's norm, and its inverse undoes it") {
  std::mt19937 random(3);
  const auto f = randomFunction(20, random);
  for (int i = 0; i < 20; ++i) {
    const ShRotation rotation(randomRotation(random), 20);
    const auto g = rotation(f);
    for (int l = 0; l < 20; ++l)
      REQUIRE(bandNorm(g, l) == doctest::Approx(bandNorm(f, l)).epsilon(1e-12));
    REQUIRE(largestDifference(rotation.inverse()(g), f) < 1e-12);
  }
}

TEST_CASE("two rotations are one, and no rotation changes nothing") {
  std::mt19937 random(4);
  const auto f = randomFunction(12, random);
  const glm::dmat3 first = randomRotation(random), second = randomRotation(random);
  const auto twice = ShRotation(second, 12)(ShRotation(first, 12)(f));
  CHECK(largestDifference(twice, ShRotation(second * first, 12)(f)) < 1e-12);
  CHECK(largestDifference(ShRotation(glm::dmat3(1), 12)(f), f) < 1e-14);
}

TEST_CASE("zonal rotation is the general rotation of a zonal function") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> zonal(15);
  for (double& coefficient : zonal) coefficient = value(random);
  ShVector<double> f(15);
  for (int l = 0; l < 15; ++l) f.at(l, 0) = zonal[l];
  for (int i = 0; i < 20; ++i) {
    const glm::dmat3 rotation = randomRotation(random);
    const auto general = ShRotation(rotation, 15)(f);
    REQUIRE(largestDifference(rotateZonal(zonal, rotation[2]), general) < 1e-12);
  }
}

TEST_CASE("a rotation rounded to float still keeps norms as well as an exact one") {
  std::mt19937 random(6);
  const auto f = randomFunction(10, random);
  const glm::mat3 rounded(randomRotation(random));
  const auto g = ShRotation(glm::dmat3(rounded), 10)(f);
  for (int l = 0; l < 10; ++l)
    CHECK(bandNorm(g, l) == doctest::Approx(bandNorm(f, l)).epsilon(1e-13));
}

TEST_CASE("colours and single precision rotate alike, and fewer bands suffice") {
  std::mt19937 random(7);
  const ShRotation rotation(randomRotation(random), 6);
  const auto f = randomFunction(4, random);
  ShVector<glm::vec3> coloured(4);
  for (int i = 0; i < f.size(); ++i) coloured[i] = glm::vec3(float(f[i]), 0, float(-f[i]));
  const auto expected = rotation(f);
  const auto rotated = rotation(coloured);
  for (int i = 0; i < f.size(); ++i) {
    CHECK(std::abs(rotated[i].x - expected[i]) < 2e-6);
    CHECK(std::abs(rotated[i].z + expected[i]) < 2e-6);
    CHECK(rotated[i].y == 0);
  }
}

TEST_CASE("what is no rotation is refused") {
  const glm::dmat3 identity(1);
  glm::dmat3 mirror(1), nothing(std::nan(""));
  mirror[0][0] = -1;
  CHECK_THROWS_AS(ShRotation(mirror, 3), std::invalid_argument);
  CHECK_THROWS_AS(ShRotation(identity * 1.01, 3), std::invalid_argument);
  CHECK_THROWS_AS(ShRotation(glm::dmat3(0), 3), std::invalid_argument);
  CHECK_THROWS_AS(ShRotation(nothing, 3), std::invalid_argument);
  CHECK_THROWS_AS(ShRotation(identity, 0), std::invalid_argument);
  CHECK_THROWS_AS(ShRotation(identity, 3)(ShVector<double>(4)), std::invalid_argument);
}
