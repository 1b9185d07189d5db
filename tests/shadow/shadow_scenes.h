#pragma once

/// Random scenes of solids, lights in all places that may matter, and what exact rays say.

#include <memory>
#include <vector>

#include "shadow/octree_refinement.h"
#include "shadow/shadow_light.h"
#include "solids/solid_samples.h"

namespace haarlight::test {

std::vector<AxisBox> boundsOf(const std::vector<Solid>& solids);

/// From 2 to 40 solids, crowded in some scenes and spread in others.
std::vector<Solid> randomScene(RandomNumbers& random);

/// Somewhere, within a solid, on a surface, straight above one, or far away, by turns.
ShadowLight lightFor(const std::vector<Solid>& solids, int i, RandomNumbers& random);

/// Whether a point of a solid's surface lies in shadow, by exact rays to all solids; of a convex
/// one itself, its normal says the rest.
bool isInShadow(const std::vector<Solid>& solids, std::size_t receiver, const glm::dvec3& point,
                const ShadowLight& light);

/// The octrees of a scene of solids, of all pairs that the coarse step keeps.
struct SolidShadows {
  SolidShadows(const std::vector<Solid>& solids, const ShadowLight& light,
               const OctreeDepths& depths);

  std::vector<ShadowOctree> octrees;
  OctreeCounts counts;
};

}  // namespace haarlight::test
