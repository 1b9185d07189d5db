#include "mesh_shadow/edge_shadow.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "shadow/convex_gap.h"
#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

struct Case {
  glm::dvec3 a, b;
  ShadowLight light;
  AxisBox cell;
};

/// Edges of all lengths, some towards the light, and cells of all sizes.
Case randomCase(RandomNumbers& random) {
  Case result;
  const double size = std::pow(10, uniform(random, -2, 0));
  result.a = randomPoint(random, 1), result.b = result.a + randomPoint(random, size);
  result.light = DirectionalLight{randomDirection(random)};
  if (random() % 2) result.light = PointLight{randomPoint(random, 3)};
  const double half = std::pow(10, uniform(random, -3, 0));
  const glm::dvec3 way = segmentToLight(result.a, result.light).direction;
  if (random() % 4 == 0)
    result.b = result.a + uniform(random, -0.5, 0.5) * way + randomPoint(random, 1e-3);
  const glm::dvec3 middle =
      result.a - uniform(random, -0.5, 2) * way + randomPoint(random, 2 * half + 0.05);
  result.cell = {middle - half, middle + half};
  return result;
}

/// By the search for a separating plane.
bool isApart(const Case& test, const Shaft& shaft, double margin) {
  const auto ends = [&](const glm::dvec3& n) {
    return glm::dot(test.b - test.a, n) > 0 ? test.b : test.a;
  };
  const auto way = [&](const glm::dvec3& n) { return shaft.support(n); };
  return gapBetween(ends, way, 0.5 * (test.a + test.b) - shaft.center(), margin).isApart;
}

}  // namespace

TEST_CASE("an edge's shadow that is said to miss a cell does, with the margin") {
  RandomNumbers random(1);
  const AxisBox scene{glm::dvec3(-3), glm::dvec3(3)};
  for (const double margin : {1e-9, 1e-3, 0.05}) {
    int missed = 0, apart = 0;
    for (int i = 0; i < 40000; ++i) {
      const Case test = randomCase(random);
      const Shaft shaft(test.cell, test.light, scene);
      const EdgeShadow shadow(test.a, test.b, test.light);
      const bool mayReach = shadow.mayReach({shaft, margin});
      if (!mayReach) REQUIRE(isApart(test, shaft, 0.99 * margin));
      missed += !mayReach;
      apart += isApart(test, shaft, margin);
    }
    MESSAGE(missed << " of " << apart << " found");
    CHECK(apart > 10000);
    if (margin < 1e-4) CHECK(missed > 0.99 * apart);  // seen from lights nearby, steps are large
  }
}

TEST_CASE("a light on an edge, an edge that is a point, and one that points to the light") {
  const glm::dvec3 place(0, 2, 0);
  const ShadowLight lamp = PointLight{place};
  const AxisBox scene{glm::dvec3(-3), glm::dvec3(3)}, cell{{1, 0, 1}, {1.5, 0.5, 1.5}};
  const Shaft shaft(cell, lamp, scene);
  CHECK(EdgeShadow({-1, 2, 0}, {1, 2, 0}, lamp).mayReach({shaft, 1e-9}));
  CHECK(EdgeShadow({0, 2, 0}, {0, 2, 0}, lamp).mayReach({shaft, 1e-9}));
  const glm::dvec3 between(0.625, 1.125, 0.625);  // half way from the cell's middle to the lamp
  CHECK(EdgeShadow(between, between, lamp).mayReach({shaft, 1e-9}));
  CHECK(EdgeShadow(between, 0.5 * (between + place), lamp).mayReach({shaft, 1e-9}));
  CHECK_FALSE(EdgeShadow(-between, -between, lamp).mayReach({shaft, 1e-9}));
  CHECK_FALSE(EdgeShadow({0, 1, 0}, {0, 0, 0}, lamp).mayReach({shaft, 1e-9}));
}
