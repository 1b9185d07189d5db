#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// The first place between `near` and `far` where the implicit function changes its sign, found by
/// small steps and halving.
std::optional<double> searchedCrossing(const Solid& solid, const Ray& ray, double step) {
  const auto inside = [&](double t) { return implicitFunction(solid, ray.at(t)) < 0; };
  const bool atStart = inside(ray.near);
  for (double low = ray.near; low < ray.far; low += step) {
    if (inside(low + step) == atStart) continue;
    double high = low + step;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (inside(middle) == atStart ? low : high) = middle;
    }
    return high;
  }
  return std::nullopt;
}

glm::dvec3 gradient(const Solid& solid, const glm::dvec3& point, double step) {
  glm::dvec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 offset(0);
    offset[axis] = step;
    result[axis] =
        (implicitFunction(solid, point + offset) - implicitFunction(solid, point - offset));
  }
  return glm::normalize(result);
}

}  // namespace

TEST_CASE("rays meet what a slow search along the implicit function finds, or graze") {
  RandomNumbers random(1);
  constexpr double step = 0.002;
  for (int kind = 0; kind < shapeKinds; ++kind) {
    int hits = 0, grazing = 0, fromInside = 0;
    for (int i = 0; i < 1000; ++i) {
      const Solid solid = randomSolid(kind, 0.2, random);
      const Ray ray{randomPoint(random, 1), randomDirection(random), 0, 4};
      const auto searched = searchedCrossing(solid, ray, step);
      const auto hit = solid.intersect(ray);
      CAPTURE(kind);
      CAPTURE(i);
      if (searched) REQUIRE(hit);
      if (!hit) continue;
      ++hits;
      fromInside += solid.contains(ray.origin);
      if (searched && std::abs(hit->t - *searched) < 1e-9) continue;
      // What the search stepped over is shorter than its step.
      Ray rest = ray;
      rest.near = hit->t + 1e-9;
      const auto next = solid.intersect(rest);
      REQUIRE(next);
      REQUIRE(next->t - hit->t < step);
      ++grazing;
    }
    CHECK(hits > 200);
    CHECK(grazing < 10);
    CHECK(fromInside > 20);
  }
}

TEST_CASE("a ray to a point of the surface meets it within 1e-9, with the surface's normal") {
  RandomNumbers random(2);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
      const Solid solid = randomSolid(kind, 2, random);
      const auto [position, normal] = randomSurfaceSample(solid, random);
      const glm::dvec3 outwards = randomDirection(random);
      const double cosine = glm::dot(outwards, normal);
      if (std::abs(cosine) < 1e-3) continue;
      const Ray ray{position + 0.01 * outwards, -outwards, 0.01 - 1e-9, 0.01 + 1e-9};
      const auto hit = solid.intersect(ray);
      CAPTURE(kind);
      CAPTURE(i);
      REQUIRE(hit);
      REQUIRE(glm::length(hit->normal - normal) < 1e-9);
      worst = std::max(worst, std::abs(hit->t - 0.01) * std::abs(cosine));
    }
    MESSAGE("kind " << kind << ": at most " << worst << " off the surface");
    CHECK(worst < 1e-14);
  }
}

TEST_CASE("normals are unit gradients") {
  RandomNumbers random(3);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
      const Solid solid = randomSolid(kind, 0.3, random);
      const auto hit = solid.intersect({2.0 * randomDirection(random), randomDirection(random)});
      if (!hit) continue;
      CHECK(glm::length(hit->normal) == doctest::Approx(1).epsilon(1e-14));
    }
    for (int i = 0; i < 3000; ++i) {
      const Solid solid = randomSolid(kind, 0.3, random);
      const glm::dvec3 origin = 2.0 * randomDirection(random);
      const Ray ray{origin, randomPoint(random, 0.5) - origin};
      const auto hit = solid.intersect(ray);
      if (!hit) continue;
      const glm::dvec3 expected = gradient(solid, ray.at(hit->t), 1e-6);
      const bool nearEdge = glm::length(expected - gradient(solid, ray.at(hit->t), 3e-6)) > 1e-4;
      if (nearEdge) continue;
      ++compared;
      REQUIRE(glm::length(hit->normal - expected) < 1e-4);
    }
    CHECK(compared > 1000);
  }
}

TEST_CASE("a ray that comes from outside enters, and leaves where the one from within does") {
  RandomNumbers random(4);
  for (int kind = 0; kind < shapeKinds; ++kind)
    for (int i = 0; i < 2000; ++i) {
      const Solid solid = randomSolid(kind, 0.3, random);
      const glm::dvec3 direction = randomDirection(random);
      const glm::dvec3 target = randomPoint(random, 0.5);
      double t = -10;
      int crossings = 0;
      while (const auto hit = solid.intersect({target, direction, t})) {
        const double along = glm::dot(hit->normal, direction);
        REQUIRE((crossings % 2 == 0 ? -along : along) >= -1e-7);
        t = hit->t + 1e-12;
        ++crossings;
      }
      REQUIRE(crossings % 2 == 0);
      REQUIRE(crossings <= (solid.isConvex() ? 2 : 4));
      if (solid.contains(target)) REQUIRE(crossings >= 2);
    }
}

TEST_CASE("a solid blocks a segment when one of many points of it lies inside") {
  RandomNumbers random(5);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    int blocked = 0;
    for (int i = 0; i < 500; ++i) {
      const Solid solid = randomSolid(kind, 0.5, random);
      const glm::dvec3 from = randomPoint(random, 1.5), to = randomPoint(random, 1.5);
      const Ray segment{from, to - from, 0, 1};
      double deepest = INFINITY;
      for (int k = 0; k <= 1000; ++k)
        deepest = std::min(deepest, implicitFunction(solid, segment.at(k / 1000.0)));
      if (deepest < 0) REQUIRE(solid.blocks(segment));
      if (deepest > 0.02) REQUIRE_FALSE(solid.blocks(segment));
      blocked += deepest < 0;
    }
    CHECK(blocked > 50);
  }
}
