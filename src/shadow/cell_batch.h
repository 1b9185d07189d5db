#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/stopwatch.h"
#include "shadow/octree_refinement.h"
#include "shadow/open_cells.h"

namespace haarlight {

/// What all cells of a receiver's octree have in common.
struct CellContext {
  const ShadowScene& scene;
  std::uint32_t receiver = 0;
  const ShadowObject& object;  ///< the receiver
  OctreeDepths depths;
  AxisBox bounds, castersBox;
  OctreeCube cube;
  double growth = 0;  ///< by which cells are larger when they are looked at

  /// A cell without what lies beyond the receiver's box, and a little larger.
  AxisBox boxOf(const CellCode& cell) const;
};

/// Merges the leaves from a place on with those before it; both are sorted.
void mergeLeaves(std::vector<ShadowLeaf>& leaves, std::size_t place);

/// Cells of one level that one thread looks at: what can be proved of them is, then their rays are
/// answered together.
class CellBatch {
 public:
  explicit CellBatch(const CellContext& context) : context_(&context) {}

  /// Looks at the root, with all that it may have.
  void lookAtRoot(const OpenCell& everything, const CellStore& store);
  /// Looks at the children of cells, in their order, each of which has its runs in one of `stores`.
  void divide(std::span<const OpenCell> cells, std::span<const CellStore> stores);
  /// Divides those that are to be divided, until none is.
  void descend();

  const OctreeCounts& counts() const { return counts_; }
  /// Sorted by their codes.
  const std::vector<ShadowLeaf>& leaves() const { return leaves_; }
  /// The cells that are to be divided.
  CellStore& store() { return store_; }

 private:
  bool isItself(const Suspect& suspect) const { return suspect.caster == context_->receiver; }
  bool isLast(const OpenCell& cell) const { return cell.code.depth == context_->depths.boundary; }
  bool isRaysBusiness(const Suspect& suspect) const;
  void look(const CellCode& code, const OpenCell& parent, const CellStore& from);
  void judge(const OpenCell& parent, const CellStore& from, const Shaft& shaft, OpenCell& cell);
  CellShadow shadowOf(const Suspect& suspect, const CellStore& from, const Shaft& shaft,
                      const OpenCell& cell);
  void askRays(const AxisBox& box, const OpenCell& cell);
  void addStarts(const AxisBox& box, const OpenCell& cell, const Suspect& suspect);
  void drawConclusions(OpenCell& cell, std::span<const std::uint8_t>& answers);
  void finish(Stopwatch& watch);
  bool isLeaf(const OpenCell& cell) const;
  void makeLeaf(const OpenCell& cell);

  const CellContext* context_;
  CellStore store_, parents_;
  std::vector<ShadowLeaf> leaves_;
  std::vector<OcclusionRay> rays_;
  std::vector<std::uint8_t> blocked_;  ///< their answers
  std::vector<glm::dvec3> starts_;
  OctreeCounts counts_;
};

}  // namespace haarlight
