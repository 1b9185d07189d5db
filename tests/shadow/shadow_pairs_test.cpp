#include "shadow/shadow_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "error_text.h"
#include "shadow/box_shadow.h"
#include "shadow/shadow_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

bool isKept(const ShadowPairs& pairs, ShadowPair pair) {
  return std::binary_search(pairs.kept.begin(), pairs.kept.end(), pair);
}

std::vector<ShadowPair> pairsByTestingAll(const std::vector<AxisBox>& boxes,
                                          const ShadowLight& light) {
  std::vector<ShadowPair> result;
  for (std::uint32_t caster = 0; caster < boxes.size(); ++caster)
    for (std::uint32_t receiver = 0; receiver < boxes.size(); ++receiver)
      if (caster == receiver || shadowOf(boxes[caster], boxes[receiver], light) != BoxShadow::none)
        result.push_back({caster, receiver});
  return result;
}

/// Points of a surface, some of which lie within the solid's box only.
std::vector<glm::dvec3> receiverPoints(const Solid& solid, RandomNumbers& random) {
  std::vector<glm::dvec3> result;
  for (int i = 0; i < 20; ++i) result.push_back(randomSurfaceSample(solid, random).position);
  return result;
}

/// `count` small solids, on a plane or in a cube.
std::vector<AxisBox> spreadBoxes(int count, bool onPlane, RandomNumbers& random) {
  std::vector<AxisBox> result;
  const double reach = onPlane ? 40 : 15;
  for (int i = 0; i < count; ++i) {
    const Solid solid = randomSolid(i % shapeKinds, reach, random);
    AxisBox box = solid.bounds();
    if (onPlane) box.upper.y -= box.lower.y, box.lower.y = 0;
    result.push_back(box);
  }
  return result;
}

}  // namespace

TEST_CASE("no pair is dropped in which a ray from a point to the light meets the other solid") {
  RandomNumbers random(1);
  int shadowed = 0, kept = 0;
  for (int i = 0; i < 60; ++i) {
    const auto solids = randomScene(random);
    const ShadowLight light = lightFor(solids, i, random);
    const ShadowPairs pairs = findShadowPairs(BoxTree(boundsOf(solids)), light);
    kept += int(pairs.kept.size() - solids.size());
    for (std::uint32_t receiver = 0; receiver < solids.size(); ++receiver) {
      const auto points = receiverPoints(solids[receiver], random);
      for (std::uint32_t caster = 0; caster < solids.size(); ++caster) {
        const bool blocks = std::any_of(points.begin(), points.end(), [&](const glm::dvec3& p) {
          return solids[caster].blocks(segmentToLight(p, light));
        });
        CAPTURE(i);
        if (blocks) REQUIRE(isKept(pairs, {caster, receiver}));
        shadowed += blocks && caster != receiver;
      }
    }
  }
  MESSAGE(kept << " pairs kept, of which " << shadowed << " were found to have a shadow");
  CHECK(shadowed > 1000);
  CHECK(shadowed > kept / 2);  // and not many for nothing
}

TEST_CASE("a receiver that touches a solid within its tolerance is paired with it") {
  const glm::dvec3 place(3, -7, 2), up(0, 1, 0);
  for (const Shape& shape : {Shape(SphereShape{1}), Shape(EllipsoidShape{{1, 1, 1}}),
                             Shape(BoxShape{{1, 1, 1}}), Shape(CylinderShape{1, 2})}) {
    const Solid caster(shape, Placement(place));
    const glm::dvec3 touching = place + (1 + 0.7e-12) * up;
    const AxisBox receiver{touching - glm::dvec3(1, 0, 1), touching + glm::dvec3(1)};
    const DirectionalLight sun{up};
    CHECK(caster.blocks(segmentToLight(touching, sun)));
    const std::vector boxes{caster.bounds(), receiver};
    CHECK(isKept(findShadowPairs(BoxTree(boxes), sun), {0, 1}));
  }
}

TEST_CASE("the tree finds the pairs that tests of all pairs find, with families or without") {
  RandomNumbers random(2);
  for (int i = 0; i < 120; ++i) {
    const auto solids = randomScene(random);
    const auto boxes = boundsOf(solids);
    const ShadowLight light = lightFor(solids, i, random);
    const auto expected = pairsByTestingAll(boxes, light);
    CAPTURE(i);
    CHECK(findShadowPairs(BoxTree(boxes), light).kept == expected);
    Family even;
    for (std::uint32_t object = 0; object < boxes.size(); object += 2)
      even.objects.push_back(object);
    CHECK(findShadowPairs(BoxTree(boxes, std::vector<Family>{even}), light).kept == expected);
  }
}

TEST_CASE("1,000 objects take less than a tenth of the tests of all pairs") {
  RandomNumbers random(3);
  constexpr int count = 1000;
  for (const bool onPlane : {true, false}) {
    const auto boxes = spreadBoxes(count, onPlane, random);
    const ShadowLight lights[] = {PointLight{{5, 30, -10}},        PointLight{{60, 8, 0}},
                                  PointLight{boxes[500].center()}, DirectionalLight{{0.5, 1, 0.2}},
                                  DirectionalLight{{1, 0.2, 0}},   DirectionalLight{{0, 1, 0}}};
    for (const ShadowLight& light : lights) {
      const ShadowPairs pairs = findShadowPairs(BoxTree(boxes), light);
      MESSAGE("plane: " << onPlane << ", light " << light.index() << ": " << pairs.tested
                        << " tested, " << pairs.dropped << " dropped, " << pairs.excluded
                        << " excluded, " << pairs.kept.size() - count << " kept");
      CHECK(pairs.tested * 10 <= count * (count - 1));
      CHECK(pairs.kept == pairsByTestingAll(boxes, light));
    }
  }
}

TEST_CASE("a row of boxes under a light: who is behind whom is never asked") {
  std::vector<AxisBox> boxes;
  for (int i = 0; i < 8; ++i) boxes.push_back({{-1, -2.0 * i, -1}, {1, 1 - 2.0 * i, 1}});
  for (const ShadowLight& light :
       {ShadowLight(PointLight{{0, 9, 0}}), ShadowLight(DirectionalLight{{0, 1, 0}})}) {
    const ShadowPairs pairs = findShadowPairs(BoxTree(boxes), light);
    CHECK(pairs.kept.size() == 8 + 28);
    for (const auto& [caster, receiver] : pairs.kept) CHECK(caster <= receiver);
    // All pairs of the tree's nodes with a common parent are excluded at once.
    CHECK(pairs.excluded == 7);
    CHECK(pairs.dropped == 0);
  }
}

TEST_CASE("every tested pair is dropped, recorded or divided, and no object is paired by itself") {
  const AxisBox left{{-2, 0, 0}, {-1, 1, 1}}, right{{1, 0, 0}, {2, 1, 1}};
  const ShadowPairs apart =
      findShadowPairs(BoxTree(std::vector{left, right}), DirectionalLight{{0, 1, 0}});
  CHECK(apart.kept == std::vector<ShadowPair>{{0, 0}, {1, 1}});
  CHECK(apart.tested == 2);
  CHECK(apart.dropped == 2);
  CHECK(apart.excluded == 0);
  const ShadowPairs inLine =
      findShadowPairs(BoxTree(std::vector{left, right}), DirectionalLight{{1, 0, 0}});
  CHECK(inLine.kept == std::vector<ShadowPair>{{0, 0}, {1, 0}, {1, 1}});
  CHECK(inLine.tested == 1);
  CHECK(inLine.excluded == 1);
  const ShadowPairs same =
      findShadowPairs(BoxTree(std::vector{left, left}), DirectionalLight{{1, 0, 0}});
  CHECK(same.kept == std::vector<ShadowPair>{{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  CHECK(same.tested == 2);
}

TEST_CASE("nothing, one object, or a light that is none") {
  const DirectionalLight sun{{0, 1, 0}};
  const ShadowPairs none = findShadowPairs(BoxTree({}), sun);
  CHECK(none.kept.empty());
  CHECK(none.tested == 0);
  const BoxTree one(std::vector<AxisBox>{{{0, 0, 0}, {1, 1, 1}}});
  CHECK(findShadowPairs(one, sun).kept == std::vector<ShadowPair>{{0, 0}});
  CHECK(findShadowPairs(one, sun).tested == 0);
  CHECK(contains(inputErrorOf([&] {
                   findShadowPairs(one, DirectionalLight{{0, 0, 0}});
                 }),
                 "directional light"));
}
