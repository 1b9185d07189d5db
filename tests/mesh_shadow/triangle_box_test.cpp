#include "mesh_shadow/triangle_box.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "shadow/convex_gap.h"
#include "shadow/shaft.h"
#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

TriangleCorners randomTriangle(double size, RandomNumbers& random) {
  const glm::dvec3 middle = randomPoint(random, 1.5);
  return {middle + randomPoint(random, size), middle + randomPoint(random, size),
          middle + randomPoint(random, size)};
}

/// By the search for a separating plane, which knows nothing of edges and faces.
bool isApart(const TriangleCorners& t, const AxisBox& box) {
  const auto triangle = [&](const glm::dvec3& n) {
    const double a = glm::dot(t[0], n), b = glm::dot(t[1], n), c = glm::dot(t[2], n);
    return a >= b && a >= c ? t[0] : b >= c ? t[1] : t[2];
  };
  const auto corner = [&](const glm::dvec3& n) { return cornerAlong(box, n); };
  return gapBetween(triangle, corner, t[0] - box.center(), 1e-13).isApart;
}

}  // namespace

TEST_CASE("a triangle meets a box exactly if no plane separates them") {
  RandomNumbers random(1);
  int meeting = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 half = 0.05 + 0.5 * (randomPoint(random, 1) + 1.0);
    const AxisBox box{-half, half};
    const TriangleCorners triangle = randomTriangle(std::pow(10, uniform(random, -2, 1)), random);
    const bool meets = triangleMeetsBox(triangle, box);
    REQUIRE(meets == !isApart(triangle, box));
    const auto point = pointInBoth(triangle, box);
    REQUIRE(point.has_value() == meets);
    if (!point) continue;
    ++meeting;
    const double rounding = 1e-12;
    CHECK(AxisBox{box.lower - rounding, box.upper + rounding}.contains(*point));
    const glm::dvec3 normal =
        glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
    CHECK(std::abs(glm::dot(normal, *point - triangle[0])) < 1e-12);
  }
  CHECK(meeting > 2000);
  CHECK(meeting < 17000);
}

TEST_CASE("a point, a line, and a triangle that touches a box") {
  const AxisBox box{{-1, -1, -1}, {1, 1, 1}};
  const glm::dvec3 corner(1, 1, 1), beyond(2, 2, 2);
  CHECK(triangleMeetsBox({corner, corner, corner}, box));
  CHECK_FALSE(triangleMeetsBox({beyond, beyond, beyond}, box));
  CHECK(triangleMeetsBox({beyond, -beyond, -beyond}, box));
  CHECK(triangleMeetsBox({glm::dvec3(1, -3, 0), {1, 3, 0}, {3, 0, 0}}, box));
  CHECK(pointInBoth({beyond, -beyond, -beyond}, box));
  CHECK_FALSE(pointInBoth({beyond, beyond, {3, 2, 2}}, box));
}
