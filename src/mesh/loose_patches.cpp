#include "mesh/loose_patches.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/mesh_measures.h"

namespace haarlight {

namespace {

constexpr std::size_t mostDebrisTriangles = 8;
constexpr double mostDebrisArea = 1e-3;          // of the other patches
constexpr std::size_t fewestSolidTriangles = 4;  // a tetrahedron's
constexpr std::size_t largeStrayRatio = 200;     // triangles of the mesh for each of them
constexpr float touchingDistance = 1e-3f;        // of the diagonal of the mesh's box

/// Small open patches and what is known of them.
class Debris {
 public:
  explicit Debris(const LoosePatches& surface)
      : surface_(surface),
        count_(surface.patches.count),
        area_(surface.patches.count),
        open_(surface.patches.count) {
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      const std::uint32_t patch = surface.patches.patchOf[i];
      ++count_[patch];
      area_[patch] += area(surface.triangles[i]);
    }
    forEachEdge(surface.edges, [&](std::span<const EdgeUse> uses) {
      const std::uint32_t patch = patchOf(uses[0]);
      if (uses.size() == 1 && count_[patch] <= mostDebrisTriangles) open_[patch] = 1;
    });
  }

  std::vector<std::uint8_t> stray() const {
    double otherArea = 0, smallArea = 0;
    for (std::size_t patch = 0; patch < open_.size(); ++patch)
      if (!open_[patch]) otherArea += area_[patch];
    std::vector<std::uint8_t> small(open_.size()), large(open_.size());
    std::size_t largeTriangles = 0;
    for (std::size_t patch = 0; patch < open_.size(); ++patch) {
      if (!open_[patch]) continue;
      const bool isSmall = area_[patch] < mostDebrisArea * otherArea;
      (isSmall ? small : large)[patch] = 1;
      if (isSmall)
        smallArea += area_[patch];
      else
        largeTriangles += count_[patch];
    }
    if (smallArea >= mostDebrisArea * otherArea) small.assign(small.size(), 0);
    if (largeTriangles < fewestSolidTriangles &&
        largeTriangles * largeStrayRatio <= surface_.triangles.size())
      keepLids(large);
    else
      large.assign(large.size(), 0);
    for (std::size_t patch = 0; patch < small.size(); ++patch) small[patch] |= large[patch];
    return small;
  }

 private:
  std::uint32_t patchOf(const EdgeUse& use) const {
    return surface_.patches.patchOf[use.triangle()];
  }

  double area(const VertexTriple& t) const {
    return triangleArea(surface_.positions[t[0]], surface_.positions[t[1]],
                        surface_.positions[t[2]]);
  }

  /// Takes the flag from patches of which every corner touches the boundary of another patch.
  void keepLids(std::vector<std::uint8_t>& flags) const {
    std::vector<std::uint8_t> lids = flags;
    const float near = touchingDistance * diagonalOfRest();
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const std::uint32_t patch = surface_.patches.patchOf[i];
      for (const std::uint32_t corner : surface_.triangles[i])
        if (lids[patch]) lids[patch] = touchesOtherBoundary(corner, patch, near);
    }
    for (std::size_t patch = 0; patch < flags.size(); ++patch) flags[patch] &= !lids[patch];
  }

  bool touchesOtherBoundary(std::uint32_t corner, std::uint32_t patch, float near) const {
    const glm::vec3& from = surface_.positions[corner];
    bool touches = false;
    forEachEdge(surface_.edges, [&](std::span<const EdgeUse> uses) {
      if (uses.size() == 1 && patchOf(uses[0]) != patch)
        touches = touches || glm::distance(from, surface_.positions[uses[0].low]) <= near ||
                  glm::distance(from, surface_.positions[uses[0].high]) <= near;
    });
    return touches;
  }

  float diagonalOfRest() const {
    glm::vec3 lower(std::numeric_limits<float>::max()), upper = -lower;
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i)
      if (!open_[surface_.patches.patchOf[i]])
        for (const std::uint32_t vertex : surface_.triangles[i]) {
          lower = glm::min(lower, surface_.positions[vertex]);
          upper = glm::max(upper, surface_.positions[vertex]);
        }
    return glm::distance(lower, upper);
  }

  const LoosePatches& surface_;
  std::vector<std::size_t> count_;  ///< of triangles, by patch
  std::vector<double> area_;        ///< by patch
  std::vector<std::uint8_t> open_;  ///< and small, by patch
};

}  // namespace

std::vector<std::uint8_t> LoosePatches::stray() const {
  return Debris(*this).stray();
}

std::vector<std::uint8_t> LoosePatches::walls(std::span<const std::uint8_t> doubled) const {
  std::vector<std::uint8_t> wall(patches.count, 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) wall[patches.patchOf[i]] &= doubled[i];
  const auto patchOf = [&](const EdgeUse& use) { return patches.patchOf[use.triangle()]; };

  // What remains must close at every rim, and some of it must be there in each connected group.
  std::vector<std::uint8_t> kept = wall;
  for (auto& flag : kept) flag = !flag;
  std::vector<std::uint8_t> closesWithout(patches.count, 1);
  DisjointSets groups(patches.count);
  forEachEdge(edges, [&](std::span<const EdgeUse> uses) {
    const auto others =
        std::ranges::count_if(uses, [&](const EdgeUse& use) { return kept[patchOf(use)] != 0; });
    for (const EdgeUse& use : uses) {
      groups.join(patchOf(uses[0]), patchOf(use));
      if (uses.size() == 1 || others % 2 != 0) closesWithout[patchOf(use)] = 0;
    }
  });
  std::vector<std::uint8_t> groupStays(patches.count);
  for (std::uint32_t patch = 0; patch < patches.count; ++patch)
    groupStays[groups.find(patch).set] |= kept[patch];
  for (std::uint32_t patch = 0; patch < patches.count; ++patch)
    wall[patch] &= closesWithout[patch] && groupStays[groups.find(patch).set];
  return wall;
}

}  // namespace haarlight
