#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("points of the surface count as inside, points just off it do not or do") {
  RandomNumbers random(1);
  for (int kind = 0; kind < shapeKinds; ++kind)
    for (int i = 0; i < 2000; ++i) {
      const Solid solid = randomSolid(kind, 1, random);
      const auto [position, normal] = randomSurfaceSample(solid, random);
      CAPTURE(kind);
      REQUIRE(solid.contains(position));
      REQUIRE_FALSE(solid.contains(position + 1e-8 * normal));
      // At an edge the way in along the normal of one face may lead out through another.
      const glm::dvec3 center = solid.placement().translation();
      if (solid.isConvex()) REQUIRE(solid.contains(position + 1e-8 * (center - position)));
      if (kind == 5) REQUIRE(solid.contains(position - 1e-8 * normal));
    }
}

TEST_CASE("what is inside has the volume of the closed form") {
  RandomNumbers random(2);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    const Solid solid = randomSolid(kind, 3, random);
    const AxisBox box = solid.bounds();
    const glm::dvec3 size = box.upper - box.lower;
    constexpr int count = 100000;
    int inside = 0;
    for (int i = 0; i < count; ++i)
      inside += solid.contains(box.lower + size * (randomPoint(random, 0.5) + 0.5));
    const double measured = size.x * size.y * size.z * inside / count;
    CAPTURE(kind);
    // Four standard deviations of the count.
    CHECK(measured ==
          doctest::Approx(volume(solid.shape())).epsilon(4 / std::sqrt(double(inside))));
  }
}

TEST_CASE("inside is where the implicit function is negative") {
  RandomNumbers random(3);
  for (int kind = 0; kind < shapeKinds; ++kind)
    for (int i = 0; i < 5000; ++i) {
      const Solid solid = randomSolid(kind, 0.5, random);
      const glm::dvec3 point = randomPoint(random, 1.5);
      const double value = implicitFunction(solid, point);
      if (std::abs(value) > 1e-9) REQUIRE(solid.contains(point) == (value < 0));
    }
}
