#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/connectivity.h"
#include "mesh/surface_patches.h"

namespace haarlight {

/// Finds the patches of a surface that bound no solid and would only disturb one (prepareSolid has
/// the rules). Flags are by patch.
struct LoosePatches {
  std::span<const glm::vec3> positions;
  std::span<const VertexTriple> triangles;
  std::span<const EdgeUse> edges;  ///< sortedEdgeUses(triangles)
  const SurfacePatches& patches;

  /// Debris beside the surface.
  std::vector<std::uint8_t> stray() const;

  /// Walls between touching solids. `doubled`: by triangle, whether it stands for an even number.
  std::vector<std::uint8_t> walls(std::span<const std::uint8_t> doubled) const;
};

}  // namespace haarlight
