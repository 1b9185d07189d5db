#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// How far a grid of surface points reaches along a direction.
double furthest(const Solid& solid, const glm::dvec3& direction) {
  constexpr int steps = 240;
  double result = -INFINITY;
  for (int part = 0; part < surfaceParts(solid.shape()); ++part)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const auto sample = surfaceSample(solid, part, double(i) / steps, double(j) / steps);
        result = std::max(result, glm::dot(sample.position, direction));
      }
  return result;
}

// A circle of radius 1 or a smaller one sinks below its tangent by at most (π/240)²/2 midway
// between two of 240 points, and in two parameters by twice that.
constexpr double gapOfGrid = 2e-4;

}  // namespace

TEST_CASE("bounds hold every surface point and touch the surface on all six sides") {
  RandomNumbers random(1);
  for (int kind = 0; kind < shapeKinds; ++kind)
    for (int i = 0; i < 4; ++i) {
      const Solid solid = randomSolid(kind, 3, random);
      const AxisBox box = solid.bounds();
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0);
        direction[axis] = 1;
        const double above = box.upper[axis] - furthest(solid, direction);
        const double below = -furthest(solid, -direction) - box.lower[axis];
        CAPTURE(kind);
        for (const double gap : {above, below}) {
          CHECK(gap >= -1e-14);
          CHECK(gap <= gapOfGrid);
        }
      }
    }
}

TEST_CASE("bounds of unturned solids are their measures") {
  const auto boundsOf = [](const Shape& shape) {
    return Solid(shape, Placement({1, 2, 3})).bounds();
  };
  const auto around = [](const glm::dvec3& half) {
    return AxisBox{glm::dvec3(1, 2, 3) - half, glm::dvec3(1, 2, 3) + half};
  };
  CHECK(boundsOf(SphereShape{0.5}) == around(glm::dvec3(0.5)));
  CHECK(boundsOf(EllipsoidShape{{0.5, 2, 4}}) == around({0.5, 2, 4}));
  CHECK(boundsOf(BoxShape{{0.5, 2, 4}}) == around({0.5, 2, 4}));
  CHECK(boundsOf(CylinderShape{2, 8}) == around({2, 4, 2}));
  CHECK(boundsOf(ConeShape{2, 8}) == around({2, 4, 2}));
  CHECK(boundsOf(ConeShape{2, 8, 4}) == around({4, 4, 4}));
  CHECK(boundsOf(TorusShape{2, 0.5}) == around({2.5, 0.5, 2.5}));
}

TEST_CASE("a support point is a point of the surface, and no surface point lies further out") {
  RandomNumbers random(2);
  for (int kind = 0; kind < shapeKinds; ++kind)
    for (int i = 0; i < 10; ++i) {
      const Solid solid = randomSolid(kind, 3, random);
      const glm::dvec3 direction = randomDirection(random);
      const glm::dvec3 support = solid.support(5.0 * direction);
      const double gap = glm::dot(support, direction) - furthest(solid, direction);
      CAPTURE(kind);
      CHECK(gap >= -1e-14);
      CHECK(gap <= gapOfGrid);
      CHECK(std::abs(implicitFunction(solid, support)) < 1e-14);
    }
}

TEST_CASE("along an axis, where many points are furthest, support gives one of them") {
  const glm::dvec3 up(0, 1, 0);
  for (const Shape& shape : {Shape(CylinderShape{2, 8}), Shape(ConeShape{2, 8, 1}),
                             Shape(TorusShape{5, 4}), Shape(BoxShape{{1, 4, 1}})}) {
    const Solid solid(shape);
    CHECK(solid.support(up).y == 4);
    CHECK(solid.support(-up).y == -4);
    CHECK(solid.contains(solid.support(up)));
  }
  CHECK(Solid(ConeShape{2, 8}).support(up) == glm::dvec3(0, 4, 0));
}

TEST_CASE("of the solids, the torus alone is not convex") {
  RandomNumbers random(3);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    const Solid solid = randomSolid(kind, 1, random);
    bool convex = true;  // as far as the middles between its points tell
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 a = randomSurfaceSample(solid, random).position;
      const glm::dvec3 b = randomSurfaceSample(solid, random).position;
      convex = convex && implicitFunction(solid, 0.5 * a + 0.5 * b) < 1e-12;
    }
    CHECK(solid.isConvex() == convex);
  }
}
