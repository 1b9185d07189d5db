#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/connectivity.h"

namespace haarlight {

/// The triangles of a surface in patches: those that can be reached from each other across edges
/// of exactly two triangles.
struct SurfacePatches {
  std::size_t count = 0;
  std::vector<std::uint32_t> patchOf;  ///< by triangle; numbered by their first triangles
  /// By triangle: whether to turn it so that the neighbours in a patch agree. (On a surface with
  /// one side only, like Möbius' strip, some edge stays where they do not.)
  std::vector<std::uint8_t> turned;
};

/// `edges`: sortedEdgeUses(triangles).
SurfacePatches surfacePatches(std::span<const VertexTriple> triangles,
                              std::span<const EdgeUse> edges);

}  // namespace haarlight
