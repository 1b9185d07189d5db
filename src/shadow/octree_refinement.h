#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shadow/occlusion_query.h"
#include "shadow/octree_counts.h"
#include "shadow/shadow_light.h"
#include "shadow/shadow_object.h"
#include "shadow/shadow_octree.h"
#include "shadow/shadow_pairs.h"

namespace haarlight {

/// How far a receiver's octree is divided.
struct OctreeDepths {
  /// At the edges of shadows; what is not proved there is decided for a point of the surface.
  int boundary = 8;
  /// Cells that are all in shadow, or all in light, are divided down to here nevertheless, so that
  /// they follow the surface. At most `boundary`; 0 for as few cells as possible.
  int interior = 0;
};

/// Throws InputError unless 0 ≤ interior ≤ boundary ≤ 10.
void checkDepths(const OctreeDepths& depths);

/// The objects of a scene, the light, and who answers rays; none is copied. The light must be one
/// that checkLight accepts.
struct ShadowScene {
  std::span<const ShadowObject* const> objects;
  const ShadowLight& light;
  const OcclusionQuery& rays;
};

/// Divides a receiver's box until every cell that its surface reaches is known to lie in the shadow
/// of one of the casters, or of none. `casters` may have the receiver. What is said of a leaf that
/// is not decided by a ray holds for all points of the surface in it (docs/lod_shadows.md), so that
/// a wrong answer lies within one cell of the boundary depth of a point for which it is right.
/// Level by level, with all threads; the result does not depend on their number. An object without
/// a box gets no leaves. Throws InputError for depths that checkDepths refuses. Adds to `counts`.
ShadowOctree buildShadowOctree(const ShadowScene& scene, std::uint32_t receiver,
                               std::span<const std::uint32_t> casters, const OctreeDepths& depths,
                               OctreeCounts& counts);

/// The casters of the coarse step's pairs for each of `count` receivers, ascending.
std::vector<std::vector<std::uint32_t>> castersByReceiver(std::span<const ShadowPair> pairs,
                                                          std::size_t count);

}  // namespace haarlight
