#include "spheres/enclosing_ball.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/builtin_meshes.h"
#include "mesh/random.h"

using namespace haarlight;

namespace {

double radiusOf(const std::vector<glm::vec3>& points) {
  return minimumEnclosingBall(points).radius;
}

}  // namespace

TEST_CASE("enclosing balls of point sets with known ones") {
  CHECK(radiusOf({}) == 0);
  CHECK(radiusOf({{1, 2, 3}}) == 0);
  CHECK(radiusOf({{1, 2, 3}, {1, 2, 3}}) == 0);
  CHECK(radiusOf({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}) == doctest::Approx(1).epsilon(1e-12));
  // Equilateral triangle of edge 1: 1 / √3; obtuse triangle: half its longest edge.
  const float height = std::sqrt(0.75f);
  CHECK(radiusOf({{0, 0, 0}, {1, 0, 0}, {0.5f, height, 0}}) ==
        doctest::Approx(1 / std::sqrt(3.0)).epsilon(1e-6));
  CHECK(radiusOf({{-1, 0, 0}, {1, 0, 0}, {0.5f, 0.2f, 0}}) == doctest::Approx(1).epsilon(1e-12));
  // Regular tetrahedron of edge √8, and the cube around it: √3.
  CHECK(radiusOf({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) ==
        doctest::Approx(std::sqrt(3.0)).epsilon(1e-12));
  std::vector<glm::vec3> cube;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  const Ball ball = minimumEnclosingBall(cube);
  CHECK(ball.radius == doctest::Approx(std::sqrt(3.0) / 2).epsilon(1e-12));
  CHECK(glm::distance(ball.center, glm::dvec3(0.5)) < 1e-12);
  CHECK(radiusOf(icosphere(4).positions) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("the enclosing ball contains all points and cannot be moved to a smaller one") {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 100; ++i) {
      const double x = random.uniform(), y = random.uniform(), z = random.uniform();
      points.emplace_back(x, y * y, round % 2 ? 0 : z);
    }
    const Ball ball = minimumEnclosingBall(points);
    const auto radiusAround = [&](const glm::dvec3& center) {
      double largest = 0;
      for (const auto& point : points)
        largest = std::max(largest, glm::distance(glm::dvec3(point), center));
      return largest;
    };
    CHECK(radiusAround(ball.center) <= ball.radius * (1 + 1e-9));
    // The largest distance is a convex function of the centre: a local minimum is the minimum.
    for (int i = 0; i < 6; ++i) {
      glm::dvec3 moved = ball.center;
      moved[i / 2] += i % 2 ? 1e-4 : -1e-4;
      CHECK(radiusAround(moved) >= ball.radius * (1 - 1e-9));
    }
  }
}
