#include "mesh/surface_patches.h"

#include <limits>

namespace haarlight {

SurfacePatches surfacePatches(std::span<const VertexTriple> triangles,
                              std::span<const EdgeUse> edges) {
  DisjointSets sets(triangles.size());
  forEachEdge(edges, [&](std::span<const EdgeUse> uses) {
    if (uses.size() == 2)
      sets.join(uses[0].triangle(), uses[1].triangle(),
                runsUpward(triangles, uses[0]) == runsUpward(triangles, uses[1]));
  });

  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  SurfacePatches patches;
  patches.patchOf.resize(triangles.size());
  patches.turned.resize(triangles.size());
  std::vector<std::uint32_t> patchOfSet(triangles.size(), none);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const DisjointSets::Member member = sets.find(i);
    std::uint32_t& patch = patchOfSet[member.set];
    if (patch == none) patch = static_cast<std::uint32_t>(patches.count++);
    patches.patchOf[i] = patch;
    patches.turned[i] = member.side;
  }
  return patches;
}

}  // namespace haarlight
