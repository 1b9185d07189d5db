#include "spheres/point_blocks.h"

#include <algorithm>
#include <utility>

namespace haarlight {

namespace {

/// Spreads the lowest ten bits to every third place.
std::uint32_t spreadBits(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000ff;
  bits = (bits | bits << 8) & 0x0300f00f;
  bits = (bits | bits << 4) & 0x030c30c3;
  return (bits | bits << 2) & 0x09249249;
}

/// Place of the point on the Morton curve through the box.
std::uint32_t mortonCode(const glm::vec3& point, const glm::vec3& lower, const glm::vec3& extent) {
  const glm::uvec3 cell((point - lower) / glm::max(extent, glm::vec3(1e-30f)) * 1023.0f);
  return spreadBits(cell.x) | spreadBits(cell.y) << 1 | spreadBits(cell.z) << 2;
}

}  // namespace

PointBlocks::PointBlocks(std::vector<glm::vec3> points) : points_(std::move(points)) {
  if (points_.empty()) return;
  Box all{points_[0], points_[0]};
  for (const glm::vec3& p : points_) all = {glm::min(all.lower, p), glm::max(all.upper, p)};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    order.emplace_back(mortonCode(points_[i], all.lower, all.upper - all.lower), i);
  std::sort(order.begin(), order.end());

  std::vector<glm::vec3> sorted;
  for (const auto& [code, index] : order) {
    const glm::vec3& p = points_[index];
    if (sorted.size() % blockSize == 0) boxes_.push_back({p, p});
    Box& box = boxes_.back();
    box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    sorted.push_back(p);
    originalPlaces_.push_back(index);
  }
  points_ = std::move(sorted);
}

}  // namespace haarlight
