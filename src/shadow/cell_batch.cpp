#include "shadow/cell_batch.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

namespace haarlight {

void mergeLeaves(std::vector<ShadowLeaf>& leaves, std::size_t place) {
  if (place == 0 || place == leaves.size()) return;
  std::inplace_merge(
      leaves.begin(), leaves.begin() + std::ptrdiff_t(place), leaves.end(),
      [](const ShadowLeaf& a, const ShadowLeaf& b) { return a.cell.first < b.cell.first; });
}

AxisBox CellContext::boxOf(const CellCode& cell) const {
  const AxisBox box = cube.box(cell);
  const AxisBox part{glm::max(box.lower, bounds.lower), glm::min(box.upper, bounds.upper)};
  if (part.isEmpty()) return part;
  return {part.lower - growth, part.upper + growth};
}

bool CellBatch::isRaysBusiness(const Suspect& suspect) const {
  return !isItself(suspect) || context_->object.castsOnItself();
}

void CellBatch::lookAtRoot(const OpenCell& everything, const CellStore& store) {
  Stopwatch watch;
  look(CellCode{}, everything, store);
  finish(watch);
}

void CellBatch::divide(std::span<const OpenCell> cells, std::span<const CellStore> stores) {
  Stopwatch watch;
  for (const OpenCell& cell : cells)
    for (std::uint32_t i = 0; i < 8; ++i) look(cell.code.child(i), cell, stores[cell.store]);
  finish(watch);
}

void CellBatch::descend() {
  while (!store_.cells.empty()) {
    std::swap(store_, parents_);
    store_.clear();
    divide(parents_.cells, std::span(&parents_, 1));
  }
  parents_ = {};
}

/// Looks at a cell with what its parent has handed down to it.
void CellBatch::look(const CellCode& code, const OpenCell& parent, const CellStore& from) {
  ++counts_.cells[code.depth];
  const AxisBox box = context_->boxOf(code);
  const std::size_t surface = store_.surface.size(), parts = store_.parts.size();
  const bool isReached =
      !box.isEmpty() &&
      context_->object.surfaceReaches(box, parent.surface.of(from.surface), store_.surface);
  counts_.unreached[code.depth] += !isReached;
  if (isReached) {
    OpenCell cell{code, 0, runSince(surface, store_.surface), {}, parent.inShadow, false};
    if (!cell.inShadow)
      judge(parent, from, Shaft(box, context_->scene.light, context_->castersBox), cell);
    if (!cell.inShadow) askRays(box, cell);
    store_.cells.push_back(cell);
    if (!isLeaf(cell)) return;
  }
  store_.surface.resize(surface), store_.parts.resize(parts);
}

/// Leaves those suspects of which something remains unknown. The receiver comes last.
void CellBatch::judge(const OpenCell& parent, const CellStore& from, const Shaft& shaft,
                      OpenCell& cell) {
  cell.suspects = {std::uint32_t(store_.suspects.size()), 0};
  for (const Suspect& suspect : parent.suspects.of(from.suspects)) {
    const bool isAttached = !isRaysBusiness(suspect);
    if (isAttached && cell.suspects.count == 0) break;  // the normal tells as much
    const std::size_t first = store_.parts.size();
    const CellShadow shadow = shadowOf(suspect, from, shaft, cell);
    if (shadow == CellShadow::all) {
      cell.inShadow = true;
      return;
    }
    if (shadow == CellShadow::none && !isAttached) {
      store_.parts.resize(first);
      continue;
    }
    store_.suspects.push_back({suspect.caster, runSince(first, store_.parts), shadow});
    ++cell.suspects.count;
  }
  if (cell.suspects.count == 0) cell.inShadow = false;
}

CellShadow CellBatch::shadowOf(const Suspect& suspect, const CellStore& from, const Shaft& shaft,
                               const OpenCell& cell) {
  const PartView parts = suspect.parts.of(from.parts);
  if (!isItself(suspect))
    return context_->scene.objects[suspect.caster]->shadowOn(shaft, parts, store_.parts);
  return context_->object.ownShadowOn(shaft, cell.surface.of(std::as_const(store_.surface)), parts,
                                      store_.parts);
}

/// Before the last depth, those that tell all about a suspect; then one for each.
void CellBatch::askRays(const AxisBox& box, const OpenCell& cell) {
  for (Suspect& suspect : cell.suspects.of(store_.suspects)) {
    if (!isRaysBusiness(suspect)) continue;
    if (suspect.shadow != CellShadow::uniform && !isLast(cell)) continue;
    starts_.clear();
    addStarts(box, cell, suspect);
    for (const glm::dvec3& start : starts_)
      rays_.push_back({start, suspect.caster, isItself(suspect)});
    suspect.rays = std::uint32_t(starts_.size());
  }
}

void CellBatch::addStarts(const AxisBox& box, const OpenCell& cell, const Suspect& suspect) {
  const PartView surface = cell.surface.of(std::as_const(store_.surface));
  const bool isUniform = suspect.shadow == CellShadow::uniform;
  if (isItself(suspect) && isUniform)
    context_->object.addOwnStarts(box, surface, starts_);
  else if (isItself(suspect))
    starts_.push_back(context_->object.ownStart(box, surface));
  else
    starts_.push_back(isUniform ? box.center() : context_->object.surfacePoint(box, surface));
}

/// Takes the answers to the cell's rays from those that are left. Where one point tells all about a
/// suspect, it is proved; at the last depth the first point decides about the others.
void CellBatch::drawConclusions(OpenCell& cell, std::span<const std::uint8_t>& answers) {
  const std::span<Suspect> suspects = cell.suspects.of(store_.suspects);
  std::uint32_t left = 0;
  bool isProved = false, isBlocked = false, isOpen = false;
  for (const Suspect& suspect : suspects) {
    const auto own = answers.first(suspect.rays);
    answers = answers.subspan(suspect.rays);
    const auto hits = std::uint32_t(std::ranges::count(own, 1));
    const bool isUniform = suspect.shadow == CellShadow::uniform && suspect.rays > 0;
    isProved = isProved || (isUniform && hits == suspect.rays);
    if (isUniform && (hits == 0 || hits == suspect.rays)) continue;
    if (isRaysBusiness(suspect)) isOpen = true;
    if (!own.empty() && own[0]) isBlocked = true;
    suspects[left] = suspect;
    suspects[left++].rays = 0;
  }
  cell.suspects.count = left;
  cell.byRay = isLast(cell) && isOpen && !isProved;
  if (isProved || !isOpen || isLast(cell)) cell.inShadow = isProved || isBlocked;
}

/// Casts the rays, and makes leaves of what is decided.
void CellBatch::finish(Stopwatch& watch) {
  counts_.rays += rays_.size();
  blocked_.resize(rays_.size());
  counts_.proofSeconds += watch.lap();
  if (!rays_.empty()) context_->scene.rays.answerHere(rays_, blocked_);
  counts_.raySeconds += watch.lap();
  const std::size_t before = leaves_.size();
  std::span<const std::uint8_t> answers(blocked_);
  for (OpenCell& cell : store_.cells) {
    if (!cell.inShadow) drawConclusions(cell, answers);
    if (isLeaf(cell)) makeLeaf(cell);
  }
  std::erase_if(store_.cells, [&](const OpenCell& cell) { return isLeaf(cell); });
  rays_.clear();
  counts_.proofSeconds += watch.lap();
  mergeLeaves(leaves_, before);
  counts_.sortSeconds += watch.lap();
}

bool CellBatch::isLeaf(const OpenCell& cell) const {
  return cell.inShadow && cell.code.depth >= context_->depths.interior;
}

void CellBatch::makeLeaf(const OpenCell& cell) {
  leaves_.push_back({cell.code, *cell.inShadow, cell.byRay});
  ++(*cell.inShadow ? counts_.inShadow : counts_.inLight)[cell.code.depth];
  counts_.byRay += cell.byRay;
}

}  // namespace haarlight
