#include "spheres/free_disc_part.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "spheres/random_spheres.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Area that two unit discs have in common when their centres are `distance` apart.
double commonArea(double distance) {
  if (distance >= 2) return 0;
  return 2 * std::acos(distance / 2) - distance / 2 * std::sqrt(4 - distance * distance);
}

/// The mean free part of the ball around two unit spheres whose centres are `distance` apart: from
/// the angle t to their axis, the discs' centres are distance · sin t apart.
double freePartOfPair(double distance) {
  const int steps = 2000;
  double covered = 0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    covered += 2 * std::numbers::pi - commonArea(distance * std::sqrt(1 - cosine * cosine));
  }
  const double radius = 1 + distance / 2;
  return 1 - covered / steps / (std::numbers::pi * radius * radius);
}

/// The mean free part from random lines through the ball.
double freePartByLines(const Ball& ball, const std::vector<Sphere>& spheres, int lines) {
  Random random(5);
  int free = 0;
  for (int i = 0; i < lines; ++i) {
    const glm::dvec3 direction = randomDirection(random);
    const glm::dvec3 aside = glm::normalize(glm::cross(direction, randomDirection(random)));
    const glm::dvec3 point = ball.center + aside * (ball.radius * std::sqrt(random.uniform()));
    free += std::none_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
      const glm::dvec3 offset = glm::dvec3(sphere.center) - point;
      return glm::length(glm::cross(offset, direction)) < sphere.radius;
    });
  }
  return double(free) / lines;
}

}  // namespace

TEST_CASE("spheres leave free nothing of their own disc, and all of one that they hardly fill") {
  const Sphere unit{{1, 2, 3}, 1};
  CHECK(meanFreePart({{1, 2, 3}, 1}, std::vector{unit}) < 1e-12);
  CHECK(meanFreePart({{1, 2, 3}, 1}, {}) == 1);
  // A disc of radius 1 in one of radius 2, wherever it lies.
  for (const glm::dvec3& offset : {glm::dvec3(0), glm::dvec3(0, 0.9, 0), glm::dvec3(0.5, 0.5, 0.5)})
    CHECK(std::abs(meanFreePart({glm::dvec3(unit.center) + offset, 2}, std::vector{unit}) - 0.75) <
          0.006);
}

TEST_CASE("the part of a ball's disc that spheres leave free") {
  for (const double distance : {0.5, 1.0, 2.0, 3.0, 10.0}) {
    const glm::dvec3 offset = glm::normalize(glm::dvec3(1, 2, 3)) * distance;
    const std::vector<Sphere> pair = {{{0, 0, 0}, 1}, {offset, 1}};
    const double part = meanFreePart(minimumEnclosingBall(pair), pair);
    CHECK(std::abs(part - freePartOfPair(distance)) < 0.006);
  }
  for (const std::size_t count : {3, 10, 100, 1000}) {
    const std::vector<Sphere> spheres = randomSpheres(count, count + 1);
    const Ball ball = minimumEnclosingBall(spheres);
    const int lines = 20000;
    const double expected = freePartByLines(ball, spheres, lines);
    const double deviation = std::sqrt(expected * (1 - expected) / lines);
    CHECK(std::abs(meanFreePart(ball, spheres) - expected) < 4 * deviation + 0.004);
  }
}
