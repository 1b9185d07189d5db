#include "shadow/solid_object.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "shadow/convex_gap.h"
#include "shadow/shadow_scenes.h"
#include "shadow/solid_occlusion.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

AxisBox randomCell(double reach, RandomNumbers& random) {
  const glm::dvec3 middle = randomPoint(random, reach);
  const double size = std::pow(10, uniform(random, -3, 0.5));
  return {middle - 0.5 * size, middle + 0.5 * size};
}

glm::dvec3 pointIn(const AxisBox& box, RandomNumbers& random) {
  return box.lower + (box.upper - box.lower) * (randomPoint(random, 0.5) + 0.5);
}

ShadowLight randomLight(RandomNumbers& random) {
  if (random() % 2) return PointLight{randomPoint(random, 4)};
  return DirectionalLight{randomDirection(random)};
}

/// Points of a solid's surface in a cell: where rays within it meet the surface.
std::vector<SurfaceSample> surfaceIn(const AxisBox& cell, const Solid& solid,
                                     RandomNumbers& random) {
  std::vector<SurfaceSample> result;
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 a = pointIn(cell, random), way = pointIn(cell, random) - a;
    if (const auto hit = solid.intersect({a, way, 0, 1}))
      result.push_back({a + hit->t * way, hit->normal});
  }
  return result;
}

}  // namespace

TEST_CASE("balls are apart exactly if their middles are further apart than their radii") {
  RandomNumbers random(1);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 a = randomPoint(random, 1), b = randomPoint(random, 1);
    const double distance = glm::distance(a, b), r = uniform(random, 0, distance);
    const double gap = std::pow(10, uniform(random, -6, 0)) * (i % 2 ? 1 : -1);
    const double s = distance - r - gap;
    if (s < 0) continue;
    const auto first = [&](const glm::dvec3& n) { return a + r * n; };
    const auto second = [&](const glm::dvec3& n) { return b + s * n; };
    const ConvexGap found = gapBetween(first, second, randomDirection(random), 1e-12);
    CHECK(found.isApart == (gap > 0));
    if (gap > 0) continue;
    CHECK(glm::distance(found.nearest, a) <= r + 1e-12);
    CHECK(glm::distance(found.nearest, b) <= s + 1e-6);
  }
}

TEST_CASE("what is said of a cell's shadow holds for all of its points") {
  RandomNumbers random(2);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    int none = 0, all = 0, unknown = 0, mixed = 0;
    for (int i = 0; i < 3000; ++i) {
      const Solid solid = randomSolid(kind, 1, random);
      const ShadowLight light = randomLight(random);
      const AxisBox cell = randomCell(2, random);
      Parts parts;
      const auto object = makeShadowObject(solid);
      const CellShadow shadow = object->shadowOn(Shaft(cell, light, object->bounds()), {}, parts);
      int blocked = 0;
      constexpr int points = 40;
      for (int k = 0; k < points; ++k)
        blocked += blocksLight(solid, pointIn(cell, random), light, false);
      CAPTURE(kind);
      if (shadow == CellShadow::none) REQUIRE(blocked == 0);
      if (shadow == CellShadow::all) REQUIRE(blocked == points);
      none += shadow == CellShadow::none, all += shadow == CellShadow::all;
      unknown += shadow == CellShadow::unknown;
      mixed += blocked > 0 && blocked < points;
    }
    MESSAGE("kind " << kind << ": " << none << " none, " << all << " all, " << unknown
                    << " unknown, of which " << mixed << " have both");
    CHECK(none > 500);
    CHECK(all > 100);
    CHECK(unknown < (kind == 5 ? 3 : 1.5) * mixed + 100);  // balls around cells see less
  }
}

TEST_CASE("what is said of a cell's own shadow holds for the surface in it") {
  RandomNumbers random(3);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    int none = 0, all = 0;
    for (int i = 0; i < 3000; ++i) {
      const Solid solid = randomSolid(kind, 0, random);
      const ShadowLight light = randomLight(random);
      const AxisBox cell = randomCell(1, random);
      Parts parts;
      const auto object = makeShadowObject(solid);
      const CellShadow shadow =
          object->ownShadowOn(Shaft(cell, light, object->bounds()), {}, {}, parts);
      CAPTURE(kind);
      for (const auto& [position, normal] : surfaceIn(cell, solid, random)) {
        none += shadow == CellShadow::none, all += shadow == CellShadow::all;
        const bool blocked = facesAway(normal, position, light) ||
                             (!solid.isConvex() && blocksLight(solid, position, light, true));
        if (shadow == CellShadow::none) REQUIRE_FALSE(blocked);
        if (shadow == CellShadow::all) REQUIRE(blocked);
      }
    }
    CHECK(all > 500);
    if (kind == 5) CHECK(none > 300);
    if (kind < 5) CHECK(none == 0);
  }
}

TEST_CASE("cells that the surface does not reach are dropped, and only these") {
  RandomNumbers random(4);
  for (int kind = 0; kind < shapeKinds; ++kind) {
    int reached = 0, dropped = 0, found = 0;
    for (int i = 0; i < 3000; ++i) {
      const Solid solid = randomSolid(kind, 0, random);
      const AxisBox cell = randomCell(1, random);
      const auto object = makeShadowObject(solid);
      Parts parts;
      const auto surface = surfaceIn(cell, solid, random);
      CAPTURE(kind);
      if (!object->surfaceReaches(cell, {}, parts)) {
        REQUIRE(surface.empty());
        ++dropped;
        continue;
      }
      ++reached, found += !surface.empty();
      const glm::dvec3 point = object->surfacePoint(cell, parts);
      CHECK(std::abs(implicitFunction(solid, point)) < 1e-12);
      if (kind == 5 && surface.empty()) continue;  // in doubt, a cell may stand
      const glm::dvec3 size = cell.upper - cell.lower;
      const double allowed = kind == 5 ? size.x / 8 : 1e-9;
      CHECK(AxisBox{cell.lower - allowed, cell.upper + allowed}.contains(point));
    }
    CHECK(dropped > 500);
    CHECK(found > 200);
    CHECK(reached < 2 * found);
  }
}
