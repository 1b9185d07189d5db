#pragma once

#include <array>
#include <cstdint>

#include "shadow/cell_code.h"

namespace haarlight {

/// What it took to build an octree.
struct OctreeCounts {
  using ByDepth = std::array<std::uint64_t, deepestCell + 1>;

  ByDepth cells{};          ///< looked at
  ByDepth unreached{};      ///< of these: dropped, as the receiver's surface does not reach them
  ByDepth inShadow{};       ///< leaves
  ByDepth inLight{};        ///< leaves
  std::uint64_t byRay = 0;  ///< leaves, all at the boundary depth, that hold for one point
  std::uint64_t rays = 0;
  double proofSeconds = 0, raySeconds = 0, sortSeconds = 0;  ///< that passed, whatever the threads

  OctreeCounts& operator+=(const OctreeCounts& other);
};

}  // namespace haarlight
