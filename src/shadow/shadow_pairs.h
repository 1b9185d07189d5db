#pragma once

#include <cstdint>
#include <vector>

#include "shadow/box_tree.h"
#include "shadow/shadow_light.h"

namespace haarlight {

/// Two objects by number: the first may shadow a part of the second.
struct ShadowPair {
  std::uint32_t caster, receiver;

  auto operator<=>(const ShadowPair&) const = default;
};

/// The coarse step's result.
struct ShadowPairs {
  std::vector<ShadowPair> kept;  ///< ascending; every object may shadow itself
  /// Ordered pairs of two boxes, of objects or of nodes above them, by what became of them. Pairs
  /// of a box with itself are not counted.
  std::uint64_t tested = 0;
  std::uint64_t dropped = 0;   ///< of those tested: the shadow of one misses the other
  std::uint64_t excluded = 0;  ///< not tested, because the mirrored pair's answer was `behind`
};

/// Which object's box reaches into the shadow volume of which other's (shadowOf): exactly those
/// that tests of all pairs would find. From the root of the tree down, pairs of boxes that cannot
/// matter are dropped with all that is in them. Throws InputError when the light is none
/// (checkLight).
ShadowPairs findShadowPairs(const BoxTree& tree, const ShadowLight& light);

}  // namespace haarlight
