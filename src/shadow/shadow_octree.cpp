#include "shadow/shadow_octree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "shadow/shaft.h"

namespace haarlight {

namespace {

constexpr int deepestPerEdge = 1 << deepestCell;

/// Where a box begins in the first of the deepest cells, and how much larger its cube is.
constexpr double below = 1.0 / 3, largerThanBox = 1 + 0.7 / deepestPerEdge;

bool isBefore(std::uint32_t code, const ShadowLeaf& leaf) {
  return code < leaf.cell.first;
}

}  // namespace

OctreeCube::OctreeCube(const AxisBox& box) {
  const glm::dvec3 size = box.upper - box.lower;
  const double longest = std::max({size.x, size.y, size.z});
  lower = box.lower - below * longest / deepestPerEdge;
  edge = longest * largerThanBox;
}

AxisBox OctreeCube::box(const CellCode& cell) const {
  const glm::dvec3 corner(cell.coordinates());
  const double deepestEdge = edgeAt(deepestCell);
  const double size = double(1 << (deepestCell - cell.depth));
  return {lower + deepestEdge * corner, lower + deepestEdge * (corner + size)};
}

CellCode OctreeCube::deepestCellAt(const glm::dvec3& point) const {
  if (edge == 0) return haarlight::deepestCellAt({0, 0, 0});
  const glm::dvec3 place = (point - lower) / edgeAt(deepestCell);
  return haarlight::deepestCellAt(
      glm::uvec3(glm::clamp(place, glm::dvec3(0), glm::dvec3(deepestPerEdge - 1))));
}

int OctreeCube::depthForDetail(double detail) const {
  if (!(detail > 0)) throw InputError("the level of detail, a length, must be a positive number");
  int depth = 0;
  while (depth < deepestCell && edgeAt(depth) > detail * largerThanBox) ++depth;
  return depth;
}

ShadowOctree::ShadowOctree(const OctreeCube& cube, std::vector<ShadowLeaf> leaves)
    : cube_(cube), leaves_(std::move(leaves)) {
  const auto areInOrder = [](const ShadowLeaf& a, const ShadowLeaf& b) {
    return isBefore(a.cell.first, b);
  };
  if (!std::ranges::is_sorted(leaves_, areInOrder)) std::ranges::sort(leaves_, areInOrder);
}

std::optional<ShadowLeaf> ShadowOctree::leafAt(const glm::dvec3& point) const {
  const std::uint32_t code = cube_.deepestCellAt(point).first;
  const auto after = std::upper_bound(leaves_.begin(), leaves_.end(), code, isBefore);
  if (after == leaves_.begin()) return std::nullopt;
  const ShadowLeaf& leaf = *(after - 1);
  if (code - leaf.cell.first >= leaf.cell.span()) return std::nullopt;
  return leaf;
}

std::optional<ShadowLeaf> ShadowOctree::leafNear(const glm::dvec3& point, double reach) const {
  if (const auto leaf = leafAt(point)) return leaf;
  for (const glm::dvec3& corner : cornersOf({point - reach, point + reach}))
    if (const auto leaf = leafAt(corner)) return leaf;
  return std::nullopt;
}

bool ShadowOctree::isInShadow(const glm::dvec3& point) const {
  const auto leaf = leafAt(point);
  return leaf && leaf->inShadow;
}

}  // namespace haarlight
