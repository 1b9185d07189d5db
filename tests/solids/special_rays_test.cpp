#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const glm::dvec3 right(1, 0, 0), up(0, 1, 0);

/// All places where a line meets a surface, by starting again behind each.
std::vector<double> allCrossings(const Solid& solid, const glm::dvec3& origin,
                                 const glm::dvec3& direction) {
  std::vector<double> result;
  Ray ray{origin, direction, -infinity};
  while (const auto hit = solid.intersect(ray)) {
    result.push_back(hit->t);
    ray.near = hit->t + 1e-6;
  }
  return result;
}

void checkHit(const Solid& solid, const Ray& ray, double t, const glm::dvec3& normal) {
  const auto hit = solid.intersect(ray);
  REQUIRE(hit);
  CHECK(hit->t == doctest::Approx(t).epsilon(1e-14));
  CHECK(glm::length(hit->normal - normal) < 1e-12);
}

}  // namespace

TEST_CASE("along the axes, hits are where the measures say") {
  for (const Shape& shape : {Shape(SphereShape{2}), Shape(EllipsoidShape{{2, 2, 1}}),
                             Shape(BoxShape{{2, 2, 1}}), Shape(CylinderShape{2, 4})}) {
    checkHit(Solid(shape), {-5.0 * right, right}, 3, -right);
    checkHit(Solid(shape), {5.0 * up, -up}, 3, up);
    checkHit(Solid(shape), {{0, 0, 0}, right}, 2, right);
    checkHit(Solid(shape), {{0, 0, 0}, -up}, 2, -up);
  }
  checkHit(Solid(ConeShape{1, 2}), {5.0 * up, -up}, 4, up);  // the apex
  checkHit(Solid(ConeShape{1, 2}), {-5.0 * up, up}, 4, -up);
  checkHit(Solid(ConeShape{1, 2}), {-5.0 * right, right}, 4.5,
           glm::normalize(glm::dvec3(-2, 1, 0)));
}

TEST_CASE("a torus in its plane is met four times, and along its axis not at all") {
  const Solid torus(TorusShape{2, 0.5});
  const auto met = allCrossings(torus, {-5, 0, 0}, right);
  REQUIRE(met.size() == 4);
  const double expected[] = {2.5, 3.5, 6.5, 7.5};
  for (int i = 0; i < 4; ++i) CHECK(met[i] == doctest::Approx(expected[i]).epsilon(1e-14));
  CHECK(allCrossings(torus, {0, 5, 0}, -up).empty());
  checkHit(torus, {{2, 5, 0}, -up}, 4.5, up);
  checkHit(torus, {{2, 0, 0}, right}, 0.5, right);
}

TEST_CASE("rays that touch a surface meet it, and those just beyond do not") {
  struct Touch {
    Shape shape;
    glm::dvec3 origin, normal;
    double t;
  };
  const Touch touches[] = {{SphereShape{1}, {-5, 1, 0}, up, 5},
                           {EllipsoidShape{{3, 1, 2}}, {-5, 1, 0}, up, 5},
                           {CylinderShape{1, 2}, {-5, 1, 0}, up, 4},
                           {BoxShape{{1, 1, 2}}, {-5, 1, 0}, up, 4},
                           {TorusShape{2, 1}, {-5, 1, 0}, up, 3}};
  for (const auto& [shape, origin, normal, t] : touches) {
    const Solid solid(shape);
    const auto hit = solid.intersect({origin, right});
    REQUIRE(hit);
    CHECK(hit->t == doctest::Approx(t).epsilon(1e-7));
    CHECK_FALSE(solid.intersect({origin + 1e-12 * up, right}));
    CHECK(solid.intersect({origin - 1e-12 * up, right}));
  }
}

TEST_CASE("rays within a surface meet it where they reach it") {
  checkHit(Solid(CylinderShape{1, 2}), {{1, 5, 0}, -up}, 4, up);
  checkHit(Solid(BoxShape{{1, 1, 1}}), {{1, 5, 1}, -up}, 4, up);
  CHECK_FALSE(Solid(CylinderShape{1, 2}).intersect({{1 + 1e-12, 5, 0}, -up}));
  // Down the side of a cone, towards or from its apex: on the surface or nowhere.
  const glm::dvec3 generator(0.5, -1, 0);
  for (const double sign : {1.0, -1.0})
    for (const glm::dvec3& beside : {glm::dvec3(0), glm::dvec3(1e-15, 0, 0)}) {
      const Solid cone(ConeShape{1, 2});
      const Ray ray{up - sign * 2.0 * generator + beside, sign * generator};
      if (const auto hit = cone.intersect(ray))
        CHECK(std::abs(implicitFunction(cone, ray.at(hit->t))) < 1e-7);
    }
}

TEST_CASE("from a point of the surface, near = 0 meets it and a little more passes over") {
  for (const Shape& shape : {Shape(SphereShape{1}), Shape(BoxShape{glm::dvec3(1)}),
                             Shape(CylinderShape{1, 2}), Shape(EllipsoidShape{{1, 2, 3}})}) {
    const Solid solid(shape);
    checkHit(solid, {-right, right}, 0, -right);
    checkHit(solid, {-right, right, 1e-9}, 2, right);
    CHECK_FALSE(solid.intersect({-right, -right, 1e-9}));
    CHECK(solid.blocks({-right, -right}));
  }
}

TEST_CASE("hits beyond near and far do not count, and t is in lengths of the direction") {
  const Solid sphere(SphereShape{1});
  CHECK_FALSE(sphere.intersect({-5.0 * right, right, 0, 3.9}));
  checkHit(sphere, {-5.0 * right, right, 0, 4}, 4, -right);
  checkHit(sphere, {-5.0 * right, right, 4.1, 7}, 6, right);
  checkHit(sphere, {-5.0 * right, 4.0 * right}, 1, -right);
  checkHit(sphere, {-5.0 * right, 1e-20 * right}, 4e20, -right);
  checkHit(sphere, {5.0 * right, right, -infinity}, -6, -right);
}

TEST_CASE("a segment within a solid is blocked though it meets no surface") {
  const Solid sphere(SphereShape{1});
  const Ray segment{{0.1, 0, 0}, {0.2, 0.3, 0}, 0, 1};
  CHECK(sphere.blocks(segment));
  CHECK_FALSE(sphere.intersect(segment));
  CHECK_FALSE(sphere.blocks({{2, 0, 0}, {1, 0, 0}}));
  CHECK(sphere.blocks({{2, 0, 0}, {1, 0, 0}, -1}));
  CHECK_FALSE(sphere.blocks({{0, 0, 0}, right, 1, 0}));
}

TEST_CASE("no direction, or none that is finite, meets nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RandomNumbers random(2);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    const Solid solid = randomSolid(kind, 0, random);
    for (const glm::dvec3& direction : {glm::dvec3(0), glm::dvec3(nan, 1, 0), glm::dvec3(infinity)})
      CHECK_FALSE(solid.intersect({{-5, 0, 0}, direction}));
    CHECK_FALSE(solid.intersect({glm::dvec3(nan), right}));
    CHECK_FALSE(solid.contains(glm::dvec3(nan)));
  }
}
