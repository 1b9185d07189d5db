#include "shadow/octree_refinement.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "shadow/cell_batch.h"

namespace haarlight {

namespace {

/// By how much cells are larger when they are looked at, as a part of the octree's edge, so that
/// rounding cannot put a point of the surface beside its cell.
constexpr double relativeGrowth = 1e-6;

/// Builds an octree, first level by level.
class Refinement {
 public:
  Refinement(const ShadowScene& scene, std::uint32_t receiver, const OctreeDepths& depths,
             OctreeCounts& counts)
      : context_{scene, receiver, *scene.objects[receiver], depths, {}, {}, {}, 0},
        counts_(counts) {}

  ShadowOctree build(std::span<const std::uint32_t> casters) {
    const AxisBox bounds = context_.object.bounds();
    if (bounds.isEmpty()) return {};
    context_.bounds = bounds;
    context_.cube = OctreeCube(bounds);
    context_.growth = relativeGrowth * context_.cube.edge + context_.object.tolerance();
    lookAtRoot(casters);
    while (!cells_.empty()) divide();
    return ShadowOctree(context_.cube, std::move(leaves_));
  }

 private:
  void lookAtRoot(std::span<const std::uint32_t> casters) {
    Stopwatch watch;
    CellStore store;
    const OpenCell everything = root(casters, store);
    std::vector<CellBatch> batches(1, CellBatch(context_));
    batches[0].lookAtRoot(everything, store);
    take(std::move(batches), watch.lap());
  }

  /// All that the root may have; the receiver is the last of the casters.
  OpenCell root(std::span<const std::uint32_t> casters, CellStore& store) {
    store.surface = context_.object.surfaceParts();
    bool hasItself = false;
    for (const std::uint32_t caster : casters) {
      const ShadowObject& object = *context_.scene.objects[caster];
      context_.castersBox = united(context_.castersBox, object.bounds());
      hasItself = hasItself || caster == context_.receiver;
      if (caster != context_.receiver) addSuspect(caster, object.casterParts(), store);
    }
    if (hasItself) addSuspect(context_.receiver, context_.object.ownCasterParts(), store);
    OpenCell cell;
    cell.surface = runSince(0, store.surface), cell.suspects = runSince(0, store.suspects);
    return cell;
  }

  static void addSuspect(std::uint32_t caster, const Parts& parts, CellStore& store) {
    const std::size_t first = store.parts.size();
    store.parts.insert(store.parts.end(), parts.begin(), parts.end());
    store.suspects.push_back({caster, runSince(first, store.parts)});
  }

  /// Replaces the cells by those of the next level. Once there are enough for all threads, each is
  /// divided to the end by one of them.
  void divide() {
    Stopwatch watch;
    constexpr std::size_t enough = 100, mostBatches = 400;
    const bool toTheEnd = cells_.size() >= enough;
    const std::size_t grain =
        toTheEnd || isHeavy() ? 1 + cells_.size() / mostBatches : cells_.size();
    std::vector<CellBatch> batches((cells_.size() + grain - 1) / grain, CellBatch(context_));
    parallelFor(cells_.size(), grain, [&](std::size_t begin, std::size_t end) {
      CellBatch& batch = batches[begin / grain];
      batch.divide(std::span(cells_).subspan(begin, end - begin), stores_);
      if (toTheEnd) batch.descend();
    });
    take(std::move(batches), watch.lap());
  }

  /// Whether threads take less time than starting them does.
  bool isHeavy() const {
    std::size_t parts = 0;
    for (const CellStore& store : stores_) parts += store.surface.size() + store.parts.size();
    return parts > 4000;
  }

  /// Takes what batches have found, in their order, which is that of the codes.
  void take(std::vector<CellBatch> batches, double seconds) {
    cells_.clear(), stores_.clear();
    const std::size_t before = leaves_.size();
    OctreeCounts found;
    for (CellBatch& batch : batches) {
      found += batch.counts();
      leaves_.insert(leaves_.end(), batch.leaves().begin(), batch.leaves().end());
      if (batch.store().cells.empty()) continue;
      for (OpenCell& cell : batch.store().cells) cell.store = std::uint32_t(stores_.size());
      cells_.insert(cells_.end(), batch.store().cells.begin(), batch.store().cells.end());
      stores_.push_back(std::move(batch.store()));
    }
    count(found, seconds);
    Stopwatch sorting;
    mergeLeaves(leaves_, before);
    counts_.sortSeconds += sorting.lap();
  }

  /// Threads measure their own time; what passed is divided as that is.
  void count(OctreeCounts& found, double seconds) {
    const double ofThreads = found.proofSeconds + found.raySeconds + found.sortSeconds;
    const double share = ofThreads > 0 ? seconds / ofThreads : 0;
    found.proofSeconds *= share, found.raySeconds *= share, found.sortSeconds *= share;
    counts_ += found;
  }

  CellContext context_;
  OctreeCounts& counts_;
  std::vector<CellStore> stores_;
  std::vector<OpenCell> cells_;  ///< of one level
  std::vector<ShadowLeaf> leaves_;
};

}  // namespace

void checkDepths(const OctreeDepths& depths) {
  if (depths.interior < 0 || depths.interior > depths.boundary || depths.boundary > deepestCell)
    throw InputError("octree depths must be 0 ≤ interior ≤ boundary ≤ " +
                     std::to_string(deepestCell) + ", but are " + std::to_string(depths.interior) +
                     " and " + std::to_string(depths.boundary));
}

ShadowOctree buildShadowOctree(const ShadowScene& scene, std::uint32_t receiver,
                               std::span<const std::uint32_t> casters, const OctreeDepths& depths,
                               OctreeCounts& counts) {
  checkDepths(depths);
  return Refinement(scene, receiver, depths, counts).build(casters);
}

std::vector<std::vector<std::uint32_t>> castersByReceiver(std::span<const ShadowPair> pairs,
                                                          std::size_t count) {
  std::vector<std::vector<std::uint32_t>> result(count);
  for (const auto& [caster, receiver] : pairs) result[receiver].push_back(caster);
  return result;
}

}  // namespace haarlight
