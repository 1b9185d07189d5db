#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "error_text.h"
#include "mesh/builtin_meshes.h"
#include "mesh_shadow/mesh_object.h"
#include "mesh_shadow/mesh_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Meshes of all kinds and solids of all kinds, 2 to 10 together.
std::vector<SceneObject> randomScene(RandomNumbers& random) {
  const int count = 2 + int(random() % 9);
  const double reach = uniform(random, 0.5, 3);
  std::vector<SceneObject> result;
  for (int i = 0; i < count; ++i) {
    if (random() % 3)
      result.emplace_back(randomMesh(int(random() % meshKinds), reach, random));
    else
      result.emplace_back(randomSolid(int(random() % shapeKinds), reach, random));
  }
  return result;
}

/// Somewhere, at an object's middle, or far away, by turns.
ShadowLight lightFor(const std::vector<SceneObject>& objects, int i, RandomNumbers& random) {
  switch (i % 4) {
    case 0:
      return PointLight{randomPoint(random, 6)};
    case 1:
      return PointLight{randomSample(objects[0], random).position + randomPoint(random, 0.2)};
    case 2:
      return DirectionalLight{{0, 1, 0}};
    default:
      return DirectionalLight{randomDirection(random)};
  }
}

struct Errors {
  int points = 0, wrong = 0, shadowed = 0;
};

bool hasOtherAnswerNear(const std::vector<SceneObject>& objects, std::size_t receiver,
                        const glm::dvec3& place, bool answer, double reach,
                        const ShadowLight& light, RandomNumbers& random) {
  for (int i = 0; i < 3000; ++i) {
    const auto near = sampleNear(objects[receiver], place, reach, random);
    if (near && isInShadow(objects, receiver, *near, light) == answer) return true;
  }
  return false;
}

void compare(const std::vector<SceneObject>& objects, std::size_t receiver,
             const ShadowOctree& octree, const ShadowLight& light, int depth, Errors& errors,
             RandomNumbers& random) {
  for (int i = 0; i < 60; ++i) {
    const ObjectSample sample = randomSample(objects[receiver], random);
    const auto leaf = octree.leafAt(sample.position);
    REQUIRE(leaf);
    ++errors.points;
    const bool exact = isInShadow(objects, receiver, sample, light);
    errors.shadowed += exact;
    const bool isSolid = std::holds_alternative<Solid>(objects[receiver]);
    if (leaf->inShadow == exact || (isSolid && facesAway(sample.normal, sample.position, light)))
      continue;
    ++errors.wrong;
    REQUIRE(leaf->byRay);
    REQUIRE(hasOtherAnswerNear(objects, receiver, sample.position, leaf->inShadow,
                               1.05 * octree.cube().edgeAt(depth), light, random));
  }
}

}  // namespace

TEST_CASE("meshes: wrong answers lie within one smallest cell of right ones, fewer with depth") {
  double last = 1;
  for (const int depth : {4, 6, 8}) {
    RandomNumbers random(1), sampleRandom(2);
    Errors errors;
    OctreeCounts counts;
    for (int i = 0; i < 16; ++i) {
      const auto objects = randomScene(random);
      const ShadowLight light = lightFor(objects, i, random);
      const SceneShadows shadows(objects, light, {depth, 0});
      counts += shadows.counts;
      CAPTURE(i);
      for (std::size_t receiver = 0; receiver < objects.size(); ++receiver) {
        CAPTURE(receiver);
        compare(objects, receiver, shadows.octrees[receiver], light, depth, errors, sampleRandom);
      }
    }
    std::uint64_t cells = 0;
    for (const auto n : counts.cells) cells += n;
    const double share = double(errors.wrong) / errors.points;
    MESSAGE("depth " << depth << ": " << errors.wrong << " of " << errors.points << " wrong, "
                     << errors.shadowed << " in shadow; " << cells << " cells, " << counts.byRay
                     << " leaves by ray, " << counts.rays << " rays, " << counts.proofSeconds
                     << " s + " << counts.raySeconds << " s");
    CHECK(errors.shadowed > errors.points / 10);
    CHECK(share < last / 2);
    last = share;
  }
  CHECK(last < 0.005);
}

TEST_CASE("closed meshes that cross themselves: what is proved of their own shadow holds") {
  RandomNumbers random(3);
  int proved = 0, byRay = 0, shadowed = 0;
  for (int i = 0; i < 24; ++i) {
    ShadowLight light = DirectionalLight{randomDirection(random)};
    if (i % 2) light = PointLight{randomPoint(random, i % 4 == 1 ? 0.5 : 4)};
    const std::vector<SceneObject> objects{randomClosedMesh(random)};
    const SceneShadows shadows(objects, light, {3 + i % 5, 0});
    CAPTURE(i);
    for (int k = 0; k < 200; ++k) {
      const ObjectSample sample = randomSample(objects[0], random);
      const auto leaf = shadows.octrees[0].leafAt(sample.position);
      REQUIRE(leaf);
      ++(leaf->byRay ? byRay : proved);
      if (leaf->byRay) continue;
      shadowed += leaf->inShadow;
      REQUIRE(leaf->inShadow == isInShadow(objects, 0, sample, light));
    }
  }
  MESSAGE(proved << " points in proved leaves, " << shadowed << " in shadow; " << byRay
                 << " in others");
  CHECK(shadowed > 500);
  CHECK(proved - shadowed > 300);
}
