#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/parallel.h"
#include "error_text.h"
#include "shadow/shadow_scenes.h"
#include "shadow/solid_object.h"
#include "shadow/solid_occlusion.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A floor whose top is the square |x|, |z| ≤ 2 at y = 0.
Solid makeFloor() {
  return Solid(BoxShape{{2, 0.5, 2}}, Placement({0, -0.5, 0}));
}

/// The area of the floor's top that is in shadow, and the length of one smallest cell.
double shadowArea(const Solid& caster, const ShadowLight& light, int depth) {
  const SolidShadows shadows({makeFloor(), caster}, light, {depth, 0});
  constexpr int steps = 1000;
  int count = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      count +=
          shadows.octrees[0].isInShadow({4 * (i + 0.5) / steps - 2, 0, 4 * (j + 0.5) / steps - 2});
  return 16.0 * count / (steps * steps);
}

/// That an area is right within its edge, one smallest cell wide, and at depth 10 within 0.5 %.
void checkArea(const Solid& caster, const ShadowLight& light, double area, double perimeter) {
  for (const int depth : {4, 6, 8, 10}) {
    const double found = shadowArea(caster, light, depth);
    CAPTURE(depth);
    CHECK(std::abs(found - area) < perimeter * 4.1 / (1 << depth));
    if (depth == 10) CHECK(std::abs(found / area - 1) < 0.005);
  }
}

}  // namespace

TEST_CASE("a sphere's shadow on a floor is an ellipse") {
  const double pi = std::numbers::pi;
  const Solid sphere(SphereShape{0.5}, Placement({0.1, 1, -0.2}));
  // The sun at 53° above the horizon: a ball's shadow is stretched by 1/sin.
  checkArea(sphere, DirectionalLight{{0.6, 0.8, 0}}, pi * 0.25 / 0.8, 2 * pi * 0.6);
  // A lamp 1.25 above the ball's middle sees it under asin(0.5/1.25), whose tangent is
  // 0.5/√(1.3125).
  const double radius = 2.25 * 0.5 / std::sqrt(1.25 * 1.25 - 0.25);
  checkArea(sphere, PointLight{{0.1, 2.25, -0.2}}, pi * radius * radius, 2 * pi * radius);
}

TEST_CASE("a box's shadow on a floor under the sun has the area of its projection") {
  const Solid box(BoxShape{{0.3, 0.2, 0.5}}, Placement({0.2, 1, 0}));
  // Top, and the sides that the sun sees: each times how far its light slants.
  const double slantX = 0.5 / 1, slantZ = 0.25 / 1;
  const double area = 0.6 * 1 + 0.4 * 1 * slantX + 0.4 * 0.6 * slantZ;
  checkArea(box, DirectionalLight{{0.5, 1, 0.25}}, area, 2 * (0.6 + 1) + 0.4 * 4);
}

TEST_CASE("a needle's shadow is found where the rays of all corners are free") {
  const Solid needle(CylinderShape{0.01, 3},
                     Placement({0.1, 1, 0.3}, {0, 1, 0, 1, 0, 0, 0, 0, -1}));
  const DirectionalLight sun{{0, 1, 0}};
  for (const glm::dvec3& corner : cornersOf(makeFloor().bounds()))
    CHECK_FALSE(needle.blocks(segmentToLight(corner, sun)));
  const SolidShadows shadows({makeFloor(), needle}, sun, {10, 0});
  for (double x = -1.39; x < 1.6; x += 0.01) {
    const double y = 0, off = 0.0175;
    CHECK(shadows.octrees[0].isInShadow({x, y, 0.3}));
    CHECK_FALSE(shadows.octrees[0].isInShadow({x, y, 0.3 + off}));
    CHECK_FALSE(shadows.octrees[0].isInShadow({x, y, 0.3 - off}));
  }
  CHECK_FALSE(shadows.octrees[0].isInShadow({1.61, 0, 0.3}));
  // A needle thinner than a cell leaves rays to decide, but no cell that claims to be proved free.
  const Solid hair(CylinderShape{1e-5, 3}, needle.placement());
  const SolidShadows thin({makeFloor(), hair}, sun, {6, 0});
  for (double x = -1.39; x < 1.6; x += 0.01) {
    const auto leaf = thin.octrees[0].leafAt({x, 0, 0.3});
    REQUIRE(leaf);
    CHECK((leaf->inShadow || leaf->byRay));
  }
}

TEST_CASE("a light inside a solid, or on its surface, leaves everything in shadow") {
  const Solid lamp(SphereShape{0.25}, Placement({0, 1, 0}));
  for (const double y : {1.0, 1.1, 1.25}) {
    const SolidShadows shadows({makeFloor(), lamp}, PointLight{{0, y, 0}}, {8, 0});
    REQUIRE(shadows.octrees[0].leaves().size() == 1);
    CHECK(shadows.octrees[0].leaves()[0].inShadow);
    CHECK_FALSE(shadows.octrees[0].leaves()[0].byRay);
  }
  // On the floor, which a ball stands on: light runs along the floor.
  const SolidShadows onFloor({makeFloor(), Solid(SphereShape{0.5}, Placement({1, 0.5, 0}))},
                             PointLight{{-1, 0, 0}}, {6, 0});
  CHECK(onFloor.octrees[0].leaves().size() > 0);
  CHECK(onFloor.octrees[1].leaves().size() > 0);
}

TEST_CASE("a light straight above a stack of equal boxes, whose sides it sees edge-on") {
  const Solid lower(BoxShape{{1, 0.5, 1}}), upper(BoxShape{{1, 0.5, 1}}, Placement({0, 1, 0}));
  for (const ShadowLight& light :
       {ShadowLight(DirectionalLight{{0, 1, 0}}), ShadowLight(PointLight{{0, 9, 0}})}) {
    const SolidShadows shadows({lower, upper}, light, {6, 0});
    CHECK(shadows.octrees[0].isInShadow({0.5, 0.5, 0.5}));
    CHECK_FALSE(shadows.octrees[1].isInShadow({0.5, 1.5, 0.5}));
    // What is level with the light, or faces away, is not divided for it: edges alone are.
    std::uint64_t cells = 0;
    for (const std::uint64_t n : shadows.counts.cells) cells += n;
    CHECK(cells < 6000);
    MESSAGE(cells << " cells");
  }
}

TEST_CASE("coincident, nested and touching solids") {
  const DirectionalLight sun{{0.3, 1, 0.2}};
  const Solid ball(SphereShape{1});
  const SolidShadows same({ball, ball}, sun, {6, 0});
  for (const ShadowOctree& octree : same.octrees)  // every point has the other ball's surface
    CHECK(
        std::ranges::all_of(octree.leaves(), [](const ShadowLeaf& leaf) { return leaf.inShadow; }));
  const SolidShadows nested({ball, Solid(SphereShape{0.5})}, sun, {6, 0});
  CHECK(nested.octrees[1].leaves().size() == 1);
  CHECK(nested.octrees[1].isInShadow({0, 0.5, 0}));
  CHECK_FALSE(nested.octrees[0].isInShadow({0, 1, 0}));
  const SolidShadows touching({ball, Solid(SphereShape{1}, Placement({0, 2, 0}))}, sun, {8, 0});
  CHECK(touching.octrees[0].isInShadow({0, 1, 0}));
  CHECK_FALSE(touching.octrees[1].isInShadow({0, 3, 0}));
}

TEST_CASE("a torus in its own shadow") {
  const Solid torus(TorusShape{1, 0.25});
  // The sun low in the plane of the ring: the near side shadows what faces it on the far side.
  const SolidShadows shadows({torus}, DirectionalLight{{1, 0.05, 0}}, {8, 0});
  CHECK_FALSE(shadows.octrees[0].isInShadow({1.25, 0, 0}));
  CHECK(shadows.octrees[0].isInShadow({-0.75, 0, 0}));
  CHECK_FALSE(shadows.octrees[0].isInShadow({-1, 0.25, 0}));
  CHECK_FALSE(shadows.octrees[0].isInShadow({1, 0.25, 0}));
}

TEST_CASE("nothing that casts, and nothing at all") {
  const DirectionalLight sun{{0, 1, 0}};
  const SolidShadows alone({makeFloor()}, sun, {10, 0});
  REQUIRE(alone.octrees[0].leaves().size() == 1);
  CHECK_FALSE(alone.octrees[0].isInShadow({0, 0, 0}));
  CHECK(alone.counts.rays == 0);
  CHECK(SolidShadows({}, sun, {10, 0}).octrees.empty());
}

TEST_CASE("interior depth divides what is decided, and changes no answer") {
  RandomNumbers random(5);
  const std::vector<Solid> solids{makeFloor(), Solid(SphereShape{0.5}, Placement({0, 1, 0}))};
  const DirectionalLight sun{{0.6, 0.8, 0}};
  const SolidShadows coarse(solids, sun, {7, 0}), fine(solids, sun, {7, 4});
  CHECK(fine.octrees[0].leaves().size() > coarse.octrees[0].leaves().size());
  for (const ShadowOctree& octree : fine.octrees)
    for (const ShadowLeaf& leaf : octree.leaves()) {
      CHECK(leaf.cell.depth >= 4);
      CHECK(leaf.cell.depth <= 7);
    }
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point = randomSurfaceSample(solids[0], random).position;
    CHECK(fine.octrees[0].isInShadow(point) == coarse.octrees[0].isInShadow(point));
  }
  for (const OctreeDepths wrong : {OctreeDepths{11, 0}, OctreeDepths{4, 5}, OctreeDepths{4, -1}})
    CHECK(contains(inputErrorOf([&] { checkDepths(wrong); }), "octree depths"));
}

TEST_CASE("counts add up, and no number of threads changes a leaf") {
  RandomNumbers random(6);
  const auto solids = randomScene(random);
  const ShadowLight light = PointLight{{1, 7, 2}};
  setThreadCount(1);
  const SolidShadows one(solids, light, {6, 3});
  setThreadCount(5);
  const SolidShadows five(solids, light, {6, 3});
  setThreadCount(0);
  std::uint64_t leaves = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    leaves += one.octrees[i].leaves().size();
    CHECK(std::ranges::equal(one.octrees[i].leaves(), five.octrees[i].leaves()));
  }
  const OctreeCounts& counts = one.counts;
  std::uint64_t counted = 0;
  for (int depth = 0; depth <= deepestCell; ++depth) {
    const std::uint64_t ended =
        counts.unreached[depth] + counts.inShadow[depth] + counts.inLight[depth];
    counted += counts.inShadow[depth] + counts.inLight[depth];
    REQUIRE(ended <= counts.cells[depth]);
    if (depth < deepestCell) CHECK(counts.cells[depth + 1] == 8 * (counts.cells[depth] - ended));
  }
  CHECK(counted == leaves);
  CHECK(counts.rays == five.counts.rays);
  CHECK(counts.byRay <= counts.rays);
}
