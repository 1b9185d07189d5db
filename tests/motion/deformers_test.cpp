#include "motion/deformers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <numbers>
#include <stdexcept>

#include "motion/point_cache_bytes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Axis axes[] = {Axis::x, Axis::y, Axis::z};

const BoundingBox box{{-1, 2, -3}, {3, 10, 5}};  // middle (1, 6, 1)

void checkNear(const glm::vec3& point, const glm::dvec3& expected, double tolerance = 1e-6) {
  CAPTURE(point.x);
  CAPTURE(point.y);
  CAPTURE(point.z);
  CHECK(glm::distance(glm::dvec3(point), expected) < tolerance);
}

glm::vec3 twistedPoint(const glm::vec3& point, Axis axis, double degrees) {
  return twisted(std::span(&point, 1), box, axis, degrees)[0];
}

glm::vec3 bentPoint(const glm::vec3& point, Axis axis, Axis towards, double degrees) {
  return bent(std::span(&point, 1), box, axis, towards, degrees)[0];
}

}  // namespace

TEST_CASE("a twist turns the ends against each other, right-handed, and keeps the middle") {
  // Half of 180 degrees at the top: about +y, z goes to x and x to -z.
  checkNear(twistedPoint({1, 10, 2}, Axis::y, 180), {2, 10, 1});
  checkNear(twistedPoint({2, 10, 1}, Axis::y, 180), {1, 10, 0});
  checkNear(twistedPoint({1, 2, 2}, Axis::y, 180), {0, 2, 1});
  checkNear(twistedPoint({1, 10, 2}, Axis::y, 360), {1, 10, 0});
  checkNear(twistedPoint({1, 8, 2}, Axis::y, 360), {2, 8, 1});
  CHECK(twistedPoint({3, 6, 5}, Axis::y, 77) == glm::vec3(3, 6, 5));
  CHECK(twistedPoint({1, 9, 1}, Axis::y, 77) == glm::vec3(1, 9, 1));
  // About +x, y goes to z; about +z, x goes to y.
  checkNear(twistedPoint({3, 7, 1}, Axis::x, 180), {3, 6, 2});
  checkNear(twistedPoint({2, 6, 5}, Axis::z, 180), {1, 7, 5});
}

TEST_CASE("a straight rod bends to an arc of the known circle") {
  // Length 8 and 90 degrees: radius 16 / pi, centre in +x of the middle.
  const double radius = 16 / pi;
  const glm::dvec3 center(1 + radius, 6, 1);
  const double diagonal = std::sqrt(0.5) * radius;
  checkNear(bentPoint({1, 10, 1}, Axis::y, Axis::x, 90),
            center + glm::dvec3(-diagonal, diagonal, 0));
  checkNear(bentPoint({1, 2, 1}, Axis::y, Axis::x, 90),
            center + glm::dvec3(-diagonal, -diagonal, 0));
  CHECK(bentPoint({1, 6, 1}, Axis::y, Axis::x, 90) == glm::vec3(1, 6, 1));
  constexpr int segments = 1000;
  double length = 0;
  glm::dvec3 before(0);
  for (int i = 0; i <= segments; ++i) {
    const glm::vec3 point = bentPoint({1, 2 + 8.0f * float(i) / segments, 1}, Axis::y, Axis::x, 90);
    CHECK(glm::distance(glm::dvec3(point), center) == doctest::Approx(radius).epsilon(1e-6));
    if (i > 0) length += glm::distance(glm::dvec3(point), before);
    before = point;
  }
  CHECK(length == doctest::Approx(8).epsilon(1e-5));
}

TEST_CASE("a bend by 360 degrees closes, and one by negative degrees goes the other way") {
  for (const Axis axis : axes)
    for (const Axis towards : axes) {
      if (axis == towards) continue;
      glm::vec3 lower(1, 6, 1), upper(1, 6, 1);
      lower[int(axis)] = box.lower[int(axis)];
      upper[int(axis)] = box.upper[int(axis)];
      const double length = double(upper[int(axis)]) - lower[int(axis)];
      glm::dvec3 meeting(1, 6, 1);
      meeting[int(towards)] += length / pi;  // the circle's diameter
      checkNear(bentPoint(lower, axis, towards, 360), meeting);
      checkNear(bentPoint(upper, axis, towards, 360), meeting);
      meeting[int(towards)] -= 2 * length / pi;
      checkNear(bentPoint(upper, axis, towards, -360), meeting);
    }
}

TEST_CASE("cross-sections of a bend stay rigid and stand on the bent line") {
  const std::vector<glm::vec3> section{{1, 9, 1}, {0, 9, 1}, {1, 9, 3}, {2, 9, -1}};
  const double degrees = 110, angle = degrees / 180 * pi * 3 / 8;  // 3 of 8 above the middle
  const std::vector<glm::vec3> moved = bent(section, box, Axis::y, Axis::z, degrees);
  const glm::dvec3 tangent(0, std::cos(angle), std::sin(angle));
  for (std::size_t i = 0; i < section.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      CHECK(glm::distance(moved[i], moved[k]) ==
            doctest::Approx(glm::distance(section[i], section[k])).epsilon(1e-6));
      CHECK(std::abs(glm::dot(glm::dvec3(moved[i]) - glm::dvec3(moved[k]), tangent)) < 1e-6);
    }
}

TEST_CASE("no angle is the same bits, and small angles come near it evenly") {
  std::vector<glm::vec3> points = randomFrames(1, 200, 1)[0];
  points.push_back({-0.0f, 1e-38f, -1e-30f});
  CHECK(sameBits(twisted(points, box, Axis::z, 0), points));
  CHECK(sameBits(bent(points, box, Axis::y, Axis::x, 0), points));
  CHECK(sameBits(bent(points, box, Axis::y, Axis::x, -0.0), points));
  for (const double degrees : {1.0, 1e-2, 1e-4, 1e-8, 1e-16, 1e-300, 5e-324}) {
    const auto twist = twisted(points, box, Axis::y, degrees);
    const auto bend = bent(points, box, Axis::y, Axis::x, degrees);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Points lie within 20 of the line and 2 box lengths of the middle; half an ulp is rounding.
      CHECK(glm::distance(twist[i], points[i]) < 1 * degrees + 1e-6);
      CHECK(glm::distance(bend[i], points[i]) < 2 * degrees + 1e-6);
    }
  }
}

TEST_CASE("a box without height is not deformed") {
  const BoundingBox flat{{0, 1, 0}, {2, 1, 2}};
  const std::vector<glm::vec3> points{{0, 1, 0}, {2, 1, 1}, {1, 5, 1}};
  CHECK(sameBits(twisted(points, flat, Axis::y, 90), points));
  CHECK(sameBits(bent(points, flat, Axis::y, Axis::x, 90), points));
}

TEST_CASE("nothing is bent towards itself") {
  for (const Axis axis : axes)
    CHECK_THROWS_AS(bentPoint({0, 0, 0}, axis, axis, 10), std::invalid_argument);
}
