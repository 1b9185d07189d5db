#include "shadow/octree_refinement.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "error_text.h"
#include "shadow/shadow_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Whether the surface has a point with the other answer than a wrong one nearby, looked for among
/// random points of the surface within `reach` of it along each axis.
bool hasOtherAnswerNear(const std::vector<Solid>& solids, std::size_t receiver,
                        const SurfaceSample& sample, bool answer, double reach,
                        const ShadowLight& light, RandomNumbers& random) {
  const Solid& solid = solids[receiver];
  for (int i = 0; i < 4000; ++i) {
    // Points of the surface near a point: where rays from around it meet the surface.
    const glm::dvec3 from = sample.position + randomPoint(random, reach);
    const glm::dvec3 direction = randomDirection(random);
    const auto hit = solid.intersect({from, direction, -2 * reach, 2 * reach});
    if (!hit) continue;
    const glm::dvec3 point = from + hit->t * direction;
    const glm::dvec3 away = glm::abs(point - sample.position);
    if (std::max({away.x, away.y, away.z}) > reach) continue;
    if (isInShadow(solids, receiver, point, light) == answer) return true;
  }
  return false;
}

/// In a plane with the light, rounding decides.
bool facesAwayOrNearly(const SurfaceSample& sample, const ShadowLight& light) {
  return glm::dot(sample.normal, segmentToLight(sample.position, light).direction) <= 1e-14;
}

struct Errors {
  int points = 0, wrong = 0, shadowed = 0, byRay = 0;
};

/// Compares an octree with exact rays, and finds that wrong answers are near right ones.
void compare(const std::vector<Solid>& solids, std::size_t receiver, const ShadowOctree& octree,
             const ShadowLight& light, int depth, int count, Errors& errors,
             RandomNumbers& random) {
  for (int i = 0; i < count; ++i) {
    const SurfaceSample sample = randomSurfaceSample(solids[receiver], random);
    const auto leaf = octree.leafAt(sample.position);
    REQUIRE(leaf);
    ++errors.points;
    const bool exact = isInShadow(solids, receiver, sample.position, light);
    errors.shadowed += exact;
    errors.byRay += leaf->byRay;
    if (leaf->inShadow == exact || facesAwayOrNearly(sample, light)) continue;
    ++errors.wrong;
    REQUIRE(leaf->byRay);
    REQUIRE(leaf->cell.depth == depth);
    REQUIRE(hasOtherAnswerNear(solids, receiver, sample, leaf->inShadow,
                               1.05 * octree.cube().edgeAt(depth), light, random));
  }
}

}  // namespace

TEST_CASE("wrong answers lie within one smallest cell of right ones, and get fewer with depth") {
  double last = 1;
  for (const int depth : {4, 6, 8}) {
    RandomNumbers random(1), sampleRandom(2);
    Errors errors;
    OctreeCounts counts;
    for (int i = 0; i < 24; ++i) {
      const auto solids = randomScene(random);
      const ShadowLight light = lightFor(solids, i, random);
      const SolidShadows shadows(solids, light, {depth, 0});
      counts += shadows.counts;
      CAPTURE(i);
      for (std::size_t receiver = 0; receiver < solids.size(); ++receiver)
        compare(solids, receiver, shadows.octrees[receiver], light, depth, 100, errors,
                sampleRandom);
    }
    std::uint64_t cells = 0;
    for (const auto n : counts.cells) cells += n;
    const double share = double(errors.wrong) / errors.points;
    MESSAGE("depth " << depth << ": " << errors.wrong << " of " << errors.points << " wrong, "
                     << errors.shadowed << " in shadow, " << errors.byRay << " by ray; " << cells
                     << " cells, " << counts.rays << " rays, " << counts.proofSeconds << " s + "
                     << counts.raySeconds << " s");
    CHECK(errors.shadowed > errors.points / 10);
    CHECK(share < last / 2);
    last = share;
  }
  CHECK(last < 0.003);
}
