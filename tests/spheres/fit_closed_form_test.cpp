#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/mesh_measures.h"
#include "spheres/fit_shapes.h"
#include "spheres/silhouette_error.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr auto cover = FitObjective::cover, shadow = FitObjective::shadow;

bool inUnitCube(const glm::dvec3& point) {
  const glm::dvec3 offset = glm::abs(point - 0.5);
  return std::max({offset.x, offset.y, offset.z}) <= 0.5;
}

TriangleMesh unitCube() {
  return box(glm::vec3(0), glm::vec3(1));
}

/// E of `count` ≥ 2 balls on the axis of a capsule of radius 1, the best ones: the two at the ends
/// touch the tips from within, and reach `d` into the cylinder from the centre of the half sphere;
/// the others share the rest evenly, of which each covers 2 w with a volume 4/3 π w³ outside.
double bestOnAxis(double half, int count) {
  constexpr int steps = 20000;
  double best = std::numeric_limits<double>::max();
  for (int i = 0; i <= steps; ++i) {
    const double d = half * i / steps, radius = 1 + d, height = 1 + d + std::sqrt(d * d + 2 * d);
    const double rest = std::max(0.0, half - (height - 1));
    if (count == 2 && rest > 0) continue;
    const double end = std::numbers::pi * height * height * (radius - height / 3) -
                       std::numbers::pi * (height - 1) - ballVolume(1) / 2;
    best = std::min(best, 2 * end + (rest > 0 ? (count - 2) * ballVolume(rest / (count - 2)) : 0));
  }
  return best / (2 * half * std::numbers::pi + ballVolume(1));
}

double outsideOfCapsule(const std::vector<Sphere>& spheres, double half) {
  const auto inside = [&](const glm::dvec3& point) {
    const double beyond = std::max(std::abs(point.x) - half, 0.0);
    return beyond * beyond + point.y * point.y + point.z * point.z <= 1;
  };
  return summedOutsideVolume(spheres, inside) / (2 * half * std::numbers::pi + ballVolume(1));
}

}  // namespace

TEST_CASE("one sphere for a fine sphere is that sphere") {
  const TriangleMesh sphere = sphereAt({1, 2, 3}, 2, 4);
  for (const FitObjective objective : {cover, shadow}) {
    const SphereSet set = fitFor(objective, sphere, 1).set;
    REQUIRE(set.spheres.size() == 1);
    CHECK(glm::distance(set.spheres[0].center, glm::vec3(1, 2, 3)) < 0.01f);
    CHECK(set.spheres[0].radius == doctest::Approx(2).epsilon(0.003));
    CHECK(set.measures.silhouette->mean < 0.006);
    CHECK(std::abs(*set.measures.outsideVolumeRatio -
                   (ballVolume(set.spheres[0].radius) / signedVolume(sphere) - 1)) < 0.004);
    CHECK(set.meshHash == meshHash(sphere));
  }
}

TEST_CASE("where one sphere covers all, more are not used") {
  CHECK(fitFor(cover, sphereAt({0, 0, 0}, 1, 4), 5).set.spheres.size() == 1);
}

TEST_CASE("two spheres far from each other are found") {
  const TriangleMesh pair = combined(sphereAt({-5, 0, 0}, 1, 4), sphereAt({5, 1, 0}, 0.5f, 4));
  for (const FitObjective objective : {cover, shadow}) {
    std::vector<Sphere> spheres = fitFor(objective, pair, 2).set.spheres;
    REQUIRE(spheres.size() == 2);
    if (spheres[0].center.x > 0) std::swap(spheres[0], spheres[1]);
    CHECK(glm::distance(spheres[0].center, glm::vec3(-5, 0, 0)) < 0.03f);
    CHECK(glm::distance(spheres[1].center, glm::vec3(5, 1, 0)) < 0.03f);
    CHECK(spheres[0].radius == doctest::Approx(1).epsilon(0.02));
    CHECK(spheres[1].radius == doctest::Approx(0.5).epsilon(0.02));
  }
}

TEST_CASE("one sphere around a capsule has its half length as radius") {
  const std::vector<Sphere> spheres = fitFor(cover, capsule(2), 1).set.spheres;
  REQUIRE(spheres.size() == 1);
  CHECK(glm::length(spheres[0].center) < 0.03f);
  CHECK(spheres[0].radius == doctest::Approx(3).epsilon(0.003));
}

TEST_CASE("few spheres along a capsule cost what the best on its axis do") {
  // Four end in a local optimum some percent above.
  const double above[] = {1.03, 1.03, 1.1};
  for (const int count : {2, 3, 4}) {
    const std::vector<Sphere> spheres = fitFor(cover, capsule(2), std::size_t(count)).set.spheres;
    CAPTURE(count);
    CHECK(spheres.size() == std::size_t(count));
    const double best = bestOnAxis(2, count);
    CHECK(outsideOfCapsule(spheres, 2) > best * 0.97);  // the mesh is a little smaller
    CHECK(outsideOfCapsule(spheres, 2) < best * above[count - 2]);
  }
}

TEST_CASE("eight spheres along a capsule cost less than the best six on its axis") {
  const std::vector<Sphere> spheres = fitFor(cover, capsule(2), 8).set.spheres;
  CHECK(outsideOfCapsule(spheres, 2) < bestOnAxis(2, 6));
}

TEST_CASE("one sphere around a cube goes through its corners") {
  const std::vector<Sphere> spheres = fitFor(cover, unitCube(), 1).set.spheres;
  REQUIRE(spheres.size() == 1);
  CHECK(glm::distance(spheres[0].center, glm::vec3(0.5f)) < 0.005f);
  CHECK(spheres[0].radius == doctest::Approx(std::sqrt(0.75)).epsilon(0.003));
  // V(ball) / V(cube) - 1 = √3 π / 2 - 1.
  CHECK(summedOutsideVolume(spheres, inUnitCube) ==
        doctest::Approx(std::numbers::pi * std::sqrt(3.0) / 2 - 1).epsilon(0.015));
}

TEST_CASE("eight spheres around a cube are within 3 % of those around its eighths") {
  std::vector<Sphere> around;
  for (int i = 0; i < 8; ++i)
    around.push_back({glm::vec3(i & 1, i >> 1 & 1, i >> 2) / 2.0f + 0.25f, std::sqrt(0.1875f)});
  const std::vector<Sphere> spheres = fitFor(cover, unitCube(), 8).set.spheres;
  CHECK(uncovered(unitCube(), spheres) == 0);
  CHECK(summedOutsideVolume(spheres, inUnitCube) < 1.03 * summedOutsideVolume(around, inUnitCube));
}

TEST_CASE("the one sphere with the shadow of a cube blocks at its rim as much right as wrong") {
  const TriangleMesh cube = unitCube();
  const auto errorOf = [&](float radius) {
    return silhouetteError(cube, std::vector<Sphere>{{{0.5f, 0.5f, 0.5f}, radius}}, {.seed = 3});
  };
  float bestRadius = 0;
  double least = std::numeric_limits<double>::max();
  for (float radius = 0.5f; radius < 0.87f; radius += 0.005f)
    if (const double error = errorOf(radius).mean; error < least) {
      least = error;
      bestRadius = radius;
    }
  const SphereSet set = fitFor(shadow, cube, 1).set;
  REQUIRE(set.spheres.size() == 1);
  const Sphere& sphere = set.spheres[0];
  CHECK(glm::distance(sphere.center, glm::vec3(0.5f)) < 0.01f);
  CHECK(std::abs(sphere.radius - bestRadius) < 0.015f);
  CHECK(silhouetteError(cube, set.spheres, {.seed = 3}).mean < least * 1.01);
  // Where the error is least, a larger sphere adds as much wrong as it takes away.
  const SilhouetteError smaller = errorOf(sphere.radius - 0.03f);
  const SilhouetteError larger = errorOf(sphere.radius + 0.03f);
  CHECK(larger.over - smaller.over == doctest::Approx(smaller.under - larger.under).epsilon(0.25));
}
