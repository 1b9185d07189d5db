#include "shexp/exponentiation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "sh/projection.h"
#include "sh/random_functions.h"
#include "sh/rotation.h"
#include "sh/triple_tensor.h"
#include "sh/zonal.h"
#include "shexp/zonal_functions.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double pi = std::numbers::pi;
const glm::vec3 origin(0);
/// Below every sphere's horizon there is nothing where the normal is 0.
const glm::vec3 noHorizon(0);

ShVector<double> widened(const ShexpTables& tables, const ShexpVector& f) {
  ShVector<double> result(tables.order);
  for (int i = 0; i < result.size(); ++i) result[i] = f[i];
  return result;
}

ShVector<double> visibility(const ShexpTables& tables, std::span<const Sphere> spheres) {
  return widened(tables,
                 shexpExponential(tables, sphereLogarithms(tables, spheres, origin, noHorizon)));
}

/// A sphere that fills the cap of an angular radius around a direction.
Sphere sphereAt(const glm::dvec3& direction, double angle, double distance = 3) {
  return {glm::vec3(direction * distance), float(distance * std::sin(angle))};
}

/// Spheres scattered around one direction, like a model seen from a sample.
std::vector<Sphere> cluster(int count, double coverage, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> normal;
  const glm::dvec3 middle = randomDirection(random);
  const double spread = 0.2 + 0.5 * share(random);
  std::vector<Sphere> spheres;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 offset(normal(random), normal(random), normal(random));
    const double angle = (0.3 + 0.7 * share(random)) * coverage / std::sqrt(double(count));
    spheres.push_back(sphereAt(glm::normalize(middle + spread * offset), angle));
  }
  return spheres;
}

/// The union's visibility, projected: what every method approaches.
ShVector<double> projectedUnion(int order, std::span<const Sphere> spheres) {
  return projectToSh(order, productRule(100, 200), [&](const glm::dvec3& direction) {
    for (const Sphere& sphere : spheres) {
      const glm::dvec3 center(sphere.center);
      const double along = glm::dot(direction, center);
      const double squared = glm::dot(center, center) - double(sphere.radius) * sphere.radius;
      if (along > 0 && along * along >= squared) return 0.0;
    }
    return 1.0;
  });
}

ShVector<double> one(int order) {
  ShVector<double> f(order);
  f[0] = std::sqrt(4 * pi);
  return f;
}

/// One truncated product a sphere, the method that exponentiation replaces.
ShVector<double> productChain(int order, std::span<const Sphere> spheres) {
  ShVector<double> result = one(order);
  for (const Sphere& sphere : spheres) {
    const glm::dvec3 center(sphere.center);
    const double sine = sphere.radius / glm::length(center);
    const auto zonal = capVisibility(order, std::sqrt(1 - sine * sine));
    result = product(result, rotateZonal(zonal, glm::normalize(center)));
  }
  return result;
}

/// RMS over the sphere.
double distance(const ShVector<double>& f, const ShVector<double>& g) {
  return std::sqrt(dot(f - g, f - g) / (4 * pi));
}

}  // namespace

TEST_CASE("without spheres everything is visible") {
  const ShexpTables tables(5);
  const auto open = visibility(tables, {});
  CHECK(open[0] == doctest::Approx(std::sqrt(4 * pi)).epsilon(1e-7));
  for (int i = 1; i < open.size(); ++i) CHECK(open[i] == 0);
}

TEST_CASE("one sphere's visibility is its direct projection") {
  std::mt19937 random(1);
  for (const int order : {4, 5, 6}) {
    const ShexpTables tables(order);
    double small = 0, large = 0;
    for (int degrees = 2; degrees < 90; ++degrees) {
      const double angle = degrees * pi / 180;
      const glm::dvec3 direction = randomDirection(random);
      const Sphere sphere = sphereAt(direction, angle);
      const auto exact = rotateZonal(capVisibility(order, std::cos(angle)), direction);
      double& largest = degrees <= 25 ? small : large;
      largest = std::fmax(largest, distance(visibility(tables, {&sphere, 1}), exact));
    }
    MESSAGE("order ", order, ": RMS error up to 25 degrees ", small, ", up to 90 degrees ", large);
    CHECK(small < 0.01);
    CHECK(large < 0.06);
  }
}

TEST_CASE("the sum in single precision is that of the logarithms in double") {
  std::mt19937 random(2);
  for (const int order : {4, 6}) {
    const ShexpTables tables(order);
    const auto spheres = cluster(100, 2, random);
    ShVector<double> expected(order);
    for (const Sphere& sphere : spheres) {
      const glm::dvec3 center(sphere.center);
      const double sine = sphere.radius / glm::length(center);
      const auto zonal = zonalLogarithm(capVisibility(order, std::sqrt(1 - sine * sine)));
      expected += rotateZonal(zonal, glm::normalize(center));
    }
    const auto sum = widened(tables, sphereLogarithms(tables, spheres, origin, noHorizon));
    // What is left comes from interpolation between rows.
    MESSAGE("order ", order, ": relative error ",
            distance(sum, expected) / distance(expected, 0.0 * expected));
    CHECK(distance(sum, expected) < 0.02 * distance(expected, 0.0 * expected));
  }
}

TEST_CASE("squares are those of the double-precision tensor") {
  std::mt19937 random(3);
  for (const int order : {2, 4, 6}) {
    const ShexpTables tables(order);
    const auto f = randomFunction(order, random);
    ShexpVector single{};
    for (int i = 0; i < f.size(); ++i) single[i] = float(f[i]);
    CHECK(largestDifference(widened(tables, shexpSquare(tables, single)), square(f)) < 1e-5);
  }
}

TEST_CASE("the hybrid exponential approaches the exact one as its limit falls") {
  std::mt19937 random(4);
  for (const int order : {4, 5, 6}) {
    double before = 1e9;
    const auto spheres = cluster(8, 1.2, random);
    for (const double limit : {2.0, 0.5, 0.125, 0.03125}) {
      const ShexpTables tables(order, limit);
      const auto f = sphereLogarithms(tables, spheres, origin, noHorizon);
      const double error =
          distance(widened(tables, shexpExponential(tables, f)), shExponential(widened(tables, f)));
      MESSAGE("order ", order, ", limit ", limit, ": RMS error ", error);
      CHECK(error < before);
      before = error;
    }
    CHECK(before < 0.01);
  }
}

TEST_CASE("many spheres approach the projection of their union") {
  for (const int order : {4, 5, 6}) {
    const ShexpTables tables(order);
    for (const int count : {2, 4, 16, 64}) {
      std::mt19937 random(count);
      constexpr int trials = 8;
      double error = 0, chainError = 0, blocked = 0;
      for (int trial = 0; trial < trials; ++trial) {
        const auto spheres = cluster(count, 1.2, random);
        const auto exact = projectedUnion(order, spheres);
        error += std::pow(distance(visibility(tables, spheres), exact), 2) / trials;
        chainError += std::pow(distance(productChain(order, spheres), exact), 2) / trials;
        blocked += std::pow(distance(exact, one(order)), 2) / trials;
      }
      MESSAGE("order ", order, ", ", count, " spheres: RMS error ", std::sqrt(error),
              ", of a chain of products ", std::sqrt(chainError), ", without shadows ",
              std::sqrt(blocked));
      CHECK(error < 0.1 * blocked);
      CHECK(std::sqrt(error) < 1.3 * std::sqrt(chainError) + 0.01);
    }
  }
}

TEST_CASE("turning the spheres turns the visibility") {
  std::mt19937 random(5);
  const ShexpTables tables(6);
  const glm::dmat3 rotation = randomRotation(random);
  auto spheres = cluster(20, 1.2, random);
  const auto turned = ShRotation(rotation, 6)(visibility(tables, spheres));
  for (Sphere& sphere : spheres) sphere.center = glm::vec3(rotation * glm::dvec3(sphere.center));
  CHECK(distance(visibility(tables, spheres), turned) < 1e-5);
}

TEST_CASE("only direction and angle of a sphere count") {
  const ShexpTables tables(4);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 2, 3));
  const Sphere near = sphereAt(direction, 0.5, 0.25), far = sphereAt(direction, 0.5, 4000);
  CHECK(distance(visibility(tables, {&near, 1}), visibility(tables, {&far, 1})) < 1e-5);
}

TEST_CASE("spheres that contain the sample block a hemisphere, and less below the horizon") {
  const ShexpTables tables(4);
  const glm::vec3 up(0, 0, 1);
  const Sphere around{{0, 0, 0.1f}, 1}, below{{0, 0, -2}, 1};
  ShexpVector inside{}, touching{}, hidden{};
  addSphereLogarithm(tables, around, origin, up, inside);
  CHECK(inside[0] == doctest::Approx(tables.logarithms[0] / std::sqrt(4 * pi)));
  // The root of rounding errors is a twentieth of a degree.
  addSphereLogarithm(tables, {{0, 0, 5}, 5}, origin, up, touching);
  CHECK(touching[0] == doctest::Approx(inside[0]).epsilon(2e-3));
  // Straight below, 16 (v·n)² is above 1: nothing is blocked.
  addSphereLogarithm(tables, below, origin, up, hidden);
  for (const float coefficient : hidden) CHECK(std::abs(coefficient) < 1e-6);
}

TEST_CASE("hundreds of spheres in front of each other stay finite") {
  // Where dozens of spheres overlap, low orders have no good answer, but a number they must have.
  std::mt19937 random(6);
  for (const int order : {4, 5, 6}) {
    const ShexpTables tables(order);
    for (const int count : {64, 256, 1024}) {
      const auto spheres = cluster(count, 12, random);
      const auto seen = visibility(tables, spheres);
      for (const double coefficient : seen.coefficients()) REQUIRE(std::isfinite(coefficient));
    }
  }
}

TEST_CASE("spheres never need more halvings than their number says") {
  std::mt19937 random(7);
  for (const int order : {4, 6}) {
    const ShexpTables tables(order);
    CHECK(tables.mostHalvings(0) == 0);
    for (const int count : {1, 2, 33, 500}) {
      // Hemispheres in one direction have the largest logarithm that there is.
      const Sphere around = sphereAt(randomDirection(random), pi / 2);
      const std::vector<Sphere> spheres(std::size_t(count), around);
      const auto f = sphereLogarithms(tables, spheres, origin, noHorizon);
      const int most = tables.mostHalvings(spheres.size());
      CHECK(shexpExponential(tables, f, most) == shexpExponential(tables, f));
      CHECK(shexpExponential(tables, f, most - 1) != shexpExponential(tables, f));
      CHECK(shexpVisibility(tables, spheres, origin, noHorizon) == shexpExponential(tables, f));
    }
  }
}
