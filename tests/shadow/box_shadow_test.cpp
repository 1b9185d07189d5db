#include "shadow/box_shadow.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "error_text.h"
#include "solids/solid_samples.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

using Points = std::vector<glm::dvec3>;

AxisBox boxAround(const glm::dvec3& center, const glm::dvec3& half) {
  return {center - half, center + half};
}

AxisBox randomBox(RandomNumbers& random, double reach) {
  const glm::dvec3 center = randomPoint(random, reach);
  return boxAround(center, glm::abs(randomPoint(random, 1)) + 0.01);
}

Points corners(const AxisBox& box) {
  Points result;
  for (int i = 0; i < 8; ++i)
    result.push_back({(i & 1 ? box.upper : box.lower).x, (i & 2 ? box.upper : box.lower).y,
                      (i & 4 ? box.upper : box.lower).z});
  return result;
}

/// What a box covers on its way to the light, as the corners of a convex body: to a point light,
/// box and light; to a directional one, the box and itself far away.
Points sweptCorners(const AxisBox& box, const ShadowLight& light) {
  Points result = corners(box);
  if (const auto* point = std::get_if<PointLight>(&light)) {
    result.push_back(point->position);
    return result;
  }
  for (int i = 0; i < 8; ++i)
    result.push_back(result[i] + 1000.0 * std::get<DirectionalLight>(light).towards);
  return result;
}

/// The gap between two sets of corners seen along an axis; negative where they overlap.
double gapAlong(const glm::dvec3& axis, const Points& a, const Points& b) {
  const auto range = [&](const Points& points) {
    double low = INFINITY, high = -INFINITY;
    for (const glm::dvec3& p : points) {
      low = std::min(low, glm::dot(axis, p));
      high = std::max(high, glm::dot(axis, p));
    }
    return std::pair(low, high);
  };
  const auto [lowA, highA] = range(a);
  const auto [lowB, highB] = range(b);
  return std::max(lowA - highB, lowB - highA);
}

/// The theorem of the separating axis: two convex bodies are apart iff they are so along the normal
/// of a face or along the cross product of two edges. Here, products of all directions that the
/// edges of either can have.
double largestGap(const AxisBox& caster, const AxisBox& receiver, const ShadowLight& light) {
  const Points a = corners(caster), b = sweptCorners(receiver, light);
  Points edges{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 8; ++i) edges.push_back(b.back() - b[i]);
  double result = -INFINITY;
  for (const glm::dvec3& first : edges)
    for (const glm::dvec3& second : edges) {
      const glm::dvec3 axis = glm::cross(first, second);
      if (glm::length(axis) > 1e-9) result = std::max(result, gapAlong(glm::normalize(axis), a, b));
    }
  return result;
}

ShadowLight randomLight(int i, RandomNumbers& random) {
  if (i % 3 == 0) return DirectionalLight{2.0 * randomDirection(random)};
  return PointLight{randomPoint(random, i % 3 == 1 ? 4 : 1)};
}

}  // namespace

TEST_CASE("one box shadows another where no separating axis says otherwise") {
  RandomNumbers random(1);
  int shadows = 0, misses = 0;
  for (int i = 0; i < 10000; ++i) {
    const AxisBox caster = randomBox(random, 3), receiver = randomBox(random, 3);
    const ShadowLight light = randomLight(i, random);
    const double gap = largestGap(caster, receiver, light);
    if (std::abs(gap) < 1e-9) continue;
    CAPTURE(i);
    REQUIRE((shadowOf(caster, receiver, light) != BoxShadow::none) == (gap < 0));
    ++(gap < 0 ? shadows : misses);
  }
  CHECK(shadows > 500);
  CHECK(misses > 500);
}

TEST_CASE("behind says that the mirrored pair has no shadow") {
  RandomNumbers random(2);
  int behind = 0, mutual = 0;
  for (int i = 0; i < 10000; ++i) {
    const AxisBox caster = randomBox(random, 3), receiver = randomBox(random, 3);
    const ShadowLight light = randomLight(i, random);
    const BoxShadow shadow = shadowOf(caster, receiver, light);
    if (shadow == BoxShadow::none) continue;
    const BoxShadow mirrored = shadowOf(receiver, caster, light);
    CAPTURE(i);
    REQUIRE((shadow == BoxShadow::behind) == (mirrored == BoxShadow::none));
    ++(shadow == BoxShadow::behind ? behind : mutual);
  }
  CHECK(behind > 200);
  CHECK(mutual > 200);
}

TEST_CASE("a shadow along an axis is as wide as its box, or widens from a point light") {
  const AxisBox caster = boxAround({0, 2, 0}, glm::dvec3(1));
  const DirectionalLight sun{{0, 1, 0}};
  const auto receiverAt = [](const glm::dvec3& center) {
    return boxAround(center, glm::dvec3(0.5));
  };
  CHECK(shadowOf(caster, receiverAt({1.4, -5, 0}), sun) == BoxShadow::behind);
  CHECK(shadowOf(caster, receiverAt({1.6, -5, 0}), sun) == BoxShadow::none);
  CHECK(shadowOf(caster, receiverAt({0, 9, 0}), sun) == BoxShadow::none);
  // Seen from (0, 5, 0) the rim at y = 3 is at x = y', half as far out as down: 5 at y = −5.
  const PointLight lamp{{0, 5, 0}};
  CHECK(shadowOf(caster, receiverAt({5.7, -5.5, 0}), lamp) == BoxShadow::behind);
  CHECK(shadowOf(caster, receiverAt({6.1, -5.5, 0}), lamp) == BoxShadow::none);
}

TEST_CASE("a light in a box, on it, or level with a face") {
  const AxisBox caster = boxAround({0, 0, 0}, glm::dvec3(1));
  const AxisBox far = boxAround({5, 6, 7}, glm::dvec3(1));
  for (const glm::dvec3& inOrOn : {glm::dvec3(0), glm::dvec3(0.3, 1, 0), glm::dvec3(1, 1, 1)}) {
    CHECK(shadowOf(caster, far, PointLight{inOrOn}) == BoxShadow::behind);
    CHECK(shadowOf(far, caster, PointLight{inOrOn}) == BoxShadow::none);
    const AxisBox touching = boxAround({2, 0, 0}, glm::dvec3(1));
    CHECK(shadowOf(caster, touching, PointLight{inOrOn}) == BoxShadow::some);
    CHECK(shadowOf(touching, caster, PointLight{inOrOn}) == BoxShadow::some);
  }
  const PointLight just{{0, 1 + 1e-9, 0}};
  CHECK(shadowOf(caster, boxAround({0, 5, 0}, glm::dvec3(1)), just) == BoxShadow::none);
  CHECK(shadowOf(caster, boxAround({5, 0, 0}, glm::dvec3(1)), just) == BoxShadow::behind);
  // In the plane of a face: rays along the face touch it.
  const PointLight level{{-5, 1, 0}};
  CHECK(shadowOf(caster, boxAround({5, 1.5, 0}, glm::dvec3(0.5)), level) == BoxShadow::behind);
  CHECK(shadowOf(caster, boxAround({5, 1.6, 0}, glm::dvec3(0.5)), level) == BoxShadow::none);
}

TEST_CASE(
    "coincident, nested and touching boxes shadow each other, flat and empty ones are allowed") {
  const AxisBox box = boxAround({0, 0, 0}, glm::dvec3(1));
  const AxisBox inner = boxAround({0, 0, 0}, glm::dvec3(0.5));
  const AxisBox touching = boxAround({0, -2, 0}, glm::dvec3(1));
  const AxisBox ground{{-9, -1, -9}, {9, -1, 9}};
  for (const ShadowLight& light :
       {ShadowLight(PointLight{{0, 5, 0}}), ShadowLight(PointLight{{3, 5, 1}}),
        ShadowLight(DirectionalLight{{0, 1, 0}}), ShadowLight(DirectionalLight{{1, 2, 3}})}) {
    CHECK(shadowOf(box, box, light) == BoxShadow::some);
    CHECK(shadowOf(box, inner, light) == BoxShadow::some);
    CHECK(shadowOf(inner, box, light) == BoxShadow::some);
    CHECK(shadowOf(box, touching, light) == BoxShadow::some);
    CHECK(shadowOf(touching, box, light) == BoxShadow::some);
    CHECK(shadowOf(box, ground, light) == BoxShadow::some);
    CHECK(shadowOf(box, {}, light) == BoxShadow::none);
    CHECK(shadowOf({}, box, light) == BoxShadow::none);
  }
}

TEST_CASE("boxes that touch in rounded coordinates still shadow each other") {
  RandomNumbers random(3);
  for (int i = 0; i < 2000; ++i) {
    const AxisBox caster = randomBox(random, 1e3);
    const glm::dvec3 lamp = randomPoint(random, 1e3);
    // A point next to the light's, through a corner of the caster, as far behind it as before it.
    const glm::dvec3 corner = corners(caster)[i % 8];
    const glm::dvec3 behind = corner + uniform(random, 0.001, 1) * (corner - lamp);
    REQUIRE(shadowOf(caster, {behind, behind}, PointLight{lamp}) != BoxShadow::none);
    REQUIRE(shadowOf(caster, {behind, behind}, DirectionalLight{lamp - corner}) != BoxShadow::none);
  }
}

TEST_CASE("lights that are none are refused") {
  const auto refusal = [](const ShadowLight& light) {
    return inputErrorOf([&] { checkLight(light); });
  };
  CHECK(refusal(PointLight{{0, INFINITY, 0}}) ==
        "point light: its position must be three finite numbers");
  CHECK(refusal(DirectionalLight{{0, 0, 0}}) ==
        "directional light: the direction towards it must be three finite numbers, not all 0");
  CHECK(contains(refusal(DirectionalLight{{0, NAN, 1}}), "directional light"));
  CHECK(refusal(DirectionalLight{{0, 1e-300, 0}}).empty());
}
