#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "error_text.h"
#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::string refusal(const Shape& shape) {
  return inputErrorOf([&] { Solid{shape}; });
}

/// The largest distance, as a part of `size`, between surface points and where rays meet the
/// surface on their way to them.
double worstMiss(const Solid& solid, double size, RandomNumbers& random) {
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [position, normal] = randomSurfaceSample(solid, random);
    const glm::dvec3 outwards = randomDirection(random);
    if (std::abs(glm::dot(outwards, normal)) < 0.01) continue;
    const Ray ray{position + size * outwards, -outwards, 0};
    double nearest = 1;
    Ray rest = ray;
    while (const auto hit = solid.intersect(rest)) {
      nearest = std::min(nearest, std::abs(hit->t / size - 1));
      rest.near = std::nextafter(hit->t, std::numeric_limits<double>::infinity());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace

TEST_CASE("shapes without an inside are refused, with the measure to blame") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(SphereShape{0}) ==
        "sphere: its radius is 0; a solid with an inside has measures from 1e-30 to 1e30");
  CHECK(contains(refusal(SphereShape{-1}), "sphere: its radius is -1;"));
  CHECK(contains(refusal(SphereShape{nan}), "sphere: its radius is nan;"));
  CHECK(contains(refusal(EllipsoidShape{{1, 0, 1}}), "ellipsoid: its radius is 0;"));
  CHECK(contains(refusal(BoxShape{{1, 1, 1e31}}), "box: its half size is 1e+31;"));
  CHECK(contains(refusal(CylinderShape{1, 0}), "cylinder: its height is 0;"));
  CHECK(contains(refusal(ConeShape{1, 0}), "cone: its height is 0;"));
  CHECK(contains(refusal(ConeShape{0, 1}), "cone: its radius is 0;"));
  CHECK(contains(refusal(ConeShape{1, 1, -1}), "cone: its top radius is -1;"));
  CHECK(contains(refusal(TorusShape{1, 0}), "torus: its minor radius is 0;"));
  CHECK(refusal(TorusShape{1, 1.5}) ==
        "torus: its minor radius 1.5 exceeds its major radius 1, so that its surface would pass "
        "through itself");
  CHECK(refusal(TorusShape{1, 1}).empty());
  CHECK(refusal(ConeShape{1, 1, 0}).empty());
}

TEST_CASE("a placement must be rigid, and is made exactly so") {
  const auto refused = [](const glm::dmat3& rotation) {
    return contains(inputErrorOf([&] { Placement({0, 0, 0}, rotation); }), "rotation matrix");
  };
  CHECK(refused(glm::dmat3(2)));
  CHECK(refused(glm::dmat3(0)));
  CHECK(refused(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1)));
  CHECK(refused(glm::dmat3(1, 0, 0, 0.1, 1, 0, 0, 0, 1)));
  CHECK(refused(glm::dmat3(std::numeric_limits<double>::quiet_NaN())));
  CHECK(contains(inputErrorOf([] { Placement({0, INFINITY, 0}); }), "finite"));
  const Placement mended({0, 0, 0},
                         glm::dmat3(glm::mat3(glm::dmat3(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1))));
  for (int i = 0; i < 3; ++i)
    CHECK(glm::length(mended.rotation()[i]) == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("a cone whose radii are equal is a cylinder") {
  RandomNumbers random(1);
  const Solid cone(ConeShape{0.7, 1.2, 0.7}), cylinder(CylinderShape{0.7, 1.2});
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{randomPoint(random, 1), randomDirection(random)};
    const auto a = cone.intersect(ray), b = cylinder.intersect(ray);
    REQUIRE(a.has_value() == b.has_value());
    if (a) CHECK(a->t == b->t);
  }
}

TEST_CASE("a torus without a hole has its centre in its surface") {
  const Solid torus(TorusShape{1, 1});
  CHECK(torus.contains({0, 0, 0}));
  CHECK_FALSE(torus.contains({0, 0.01, 0}));
  // In its plane, a ray from within touches the surface at the centre, but stays inside.
  const auto hit = torus.intersect({{-3, 0, 0}, {1, 0, 0}, 1.5});
  REQUIRE(hit);
  CHECK(hit->t == doctest::Approx(5).epsilon(1e-14));
  // Along its axis, a ray touches it there from outside.
  const auto touch = torus.intersect({{0, 2, 0}, {0, -1, 0}});
  REQUIRE(touch);
  CHECK(touch->t == doctest::Approx(2).epsilon(1e-7));
  CHECK(glm::length(touch->normal) == doctest::Approx(1));
  CHECK_FALSE(Solid(TorusShape{1, 1 - 1e-9}).intersect({{0, 2, 0}, {0, -1, 0}}));
}

TEST_CASE("plates, needles and wires are met within 1e-12 of their size") {
  RandomNumbers random(2);
  const glm::dmat3 rotation = randomRotation(random);
  const Shape shapes[] = {EllipsoidShape{{1, 1e-4, 1}}, EllipsoidShape{{1e-4, 1, 1e-4}},
                          BoxShape{{1, 1e-6, 1}},       CylinderShape{1, 1e-6},
                          CylinderShape{1e-6, 1},       ConeShape{1, 1e-5},
                          ConeShape{1e-5, 1},           ConeShape{1e-5, 1, 1},
                          TorusShape{1, 1e-5},          TorusShape{1, 0.999999}};
  for (const Shape& shape : shapes) {
    const double worst = worstMiss(Solid(shape, Placement({1, -2, 3}, rotation)), 1, random);
    MESSAGE("shape of kind " << shape.index() << ": " << worst);
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("solids of any size are met within 1e-12 of it") {
  RandomNumbers random(3);
  for (const double size : {1e-29, 1e-10, 1e10, 1e29}) {
    const Shape shapes[] = {
        SphereShape{size},          EllipsoidShape{size * glm::dvec3(1, 0.5, 0.3)},
        BoxShape{glm::dvec3(size)}, CylinderShape{size, size},
        ConeShape{size, size},      TorusShape{size, 0.3 * size}};
    for (const Shape& shape : shapes)
      CHECK(worstMiss(Solid(shape, Placement({}, randomRotation(random))), size, random) < 1e-12);
  }
}

TEST_CASE("far from the origin, or from far away, a hit is as exact as the coordinates") {
  RandomNumbers random(4);
  for (int kind = 0; kind < shapeKinds; ++kind)
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 center = 1e6 * randomDirection(random);
      const Solid solid(randomShape(kind, random), Placement(center, randomRotation(random)));
      const glm::dvec3 from = 1e6 * randomDirection(random);
      const auto [position, normal] = randomSurfaceSample(solid, random);
      const Ray ray{from, position - from};
      if (glm::dot(normal, glm::normalize(ray.direction)) > -0.1) continue;
      const auto hit = solid.intersect(ray);
      REQUIRE(hit);
      CHECK(std::abs(implicitFunction(solid, ray.at(hit->t))) < 1e-8);
    }
}
