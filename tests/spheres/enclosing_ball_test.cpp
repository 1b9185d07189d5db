#include "spheres/enclosing_ball.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/builtin_meshes.h"
#include "mesh/random.h"
#include "spheres/random_spheres.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::vector<Sphere> asSpheres(const std::vector<glm::vec3>& points) {
  std::vector<Sphere> spheres;
  for (const glm::vec3& point : points) spheres.push_back({point, 0});
  return spheres;
}

/// Of the smallest ball with this centre around all spheres.
double radiusAround(const std::vector<Sphere>& spheres, const glm::dvec3& center) {
  double radius = 0;
  for (const Sphere& sphere : spheres)
    radius = std::max(radius, glm::distance(glm::dvec3(sphere.center), center) + sphere.radius);
  return radius;
}

/// Contains all spheres, and cannot be moved to a smaller ball that does. The radius needed around
/// a centre is a convex function: a local minimum is the minimum.
void checkSmallest(const Ball& ball, const std::vector<Sphere>& spheres) {
  CHECK(radiusAround(spheres, ball.center) <= ball.radius * (1 + 1e-12));
  Random random(3);
  int smaller = 0;
  for (int i = 0; i < 300; ++i) {
    const double step = ball.radius * std::pow(10.0, -1 - 2 * (i % 3));
    smaller += radiusAround(spheres, ball.center + step * randomDirection(random)) <
               ball.radius * (1 - 1e-9);
  }
  CHECK(smaller == 0);
}

}  // namespace

TEST_CASE("enclosing balls of point sets with known ones") {
  const auto radiusOf = [](const std::vector<glm::vec3>& points) {
    return minimumEnclosingBall(points).radius;
  };
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
      if (round % 5 == 4) points.back() = glm::round(3.0f * points.back());  // many on one ball
    }
    checkSmallest(minimumEnclosingBall(points), asSpheres(points));
  }
}

TEST_CASE("enclosing balls of few spheres are the known ones") {
  const auto radiusOf = [](const std::vector<Sphere>& spheres) {
    return minimumEnclosingBall(spheres).radius;
  };
  CHECK(radiusOf({{{0, 0, 0}, 1}, {{5, 0, 0}, 2}}) == doctest::Approx(4).epsilon(1e-6));
  CHECK(minimumEnclosingBall(std::vector<Sphere>{{{0, 0, 0}, 1}, {{5, 0, 0}, 2}}).center.x ==
        doctest::Approx(3).epsilon(1e-6));
  const float side = std::sqrt(3.0f);
  CHECK(radiusOf({{{2, 0, 0}, 0.5f}, {{-1, side, 0}, 0.5f}, {{-1, -side, 0}, 0.5f}}) ==
        doctest::Approx(2.5).epsilon(1e-6));
  CHECK(radiusOf({{{1, 1, 1}, 1}, {{1, -1, -1}, 1}, {{-1, 1, -1}, 1}, {{-1, -1, 1}, 1}}) ==
        doctest::Approx(1 + std::sqrt(3.0)).epsilon(1e-6));
  // Spheres of radii 1, 2, 3 that touch each other: the first stays inside the ball of the others.
  CHECK(radiusOf({{{0, 0, 0}, 1}, {{3, 0, 0}, 2}, {{0, 4, 0}, 3}}) ==
        doctest::Approx(5).epsilon(1e-6));
  // Radii 2, 2, 3 touch each other: Descartes' circle theorem.
  const double bend = 1 / 2.0 + 1 / 2.0 + 1 / 3.0;
  const double bends = 2 * std::sqrt(1 / 4.0 + 1 / 6.0 + 1 / 6.0);
  CHECK(radiusOf({{{-2, 0, 0}, 2}, {{2, 0, 0}, 2}, {{0, std::sqrt(21.0f), 0}, 3}}) ==
        doctest::Approx(1 / (bends - bend)).epsilon(1e-6));
}

TEST_CASE("the enclosing ball contains all spheres and cannot be moved to a smaller one") {
  for (std::uint64_t round = 0; round < 60; ++round) {
    const std::vector<Sphere> spheres = randomSpheres(round % 2 ? 3 + round % 3 : 40, round);
    checkSmallest(minimumEnclosingBall(spheres), spheres);
  }
}
