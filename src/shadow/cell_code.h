#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace haarlight {

/// The deepest cells of an octree: 1024³.
inline constexpr int deepestCell = 10;

/// Bits 0, 1, … of a number below 1024 become bits 0, 3, …
constexpr std::uint32_t spreadBits(std::uint32_t bits) {
  // Halves move apart, then their halves.
  bits = (bits | bits << 16) & 0x030000ff;
  bits = (bits | bits << 8) & 0x0300f00f;
  bits = (bits | bits << 4) & 0x030c30c3;
  return (bits | bits << 2) & 0x09249249;
}

/// The inverse of spreadBits; what lies between the bits is left out.
constexpr std::uint32_t gatherBits(std::uint32_t spread) {
  spread &= 0x09249249;
  spread = (spread | spread >> 2) & 0x030c30c3;
  spread = (spread | spread >> 4) & 0x0300f00f;
  spread = (spread | spread >> 8) & 0x030000ff;
  return (spread | spread >> 16) & 0x000003ff;
}

/// A cell of an octree by its depth and its Morton code: the number of the first (lowest) of the
/// deepest cells in it, in the order in which the bits of their coordinates follow each other from
/// the highest down, z before y before x. So what lies in a cell follows its code without a gap.
struct CellCode {
  std::uint32_t first = 0;
  std::uint8_t depth = 0;

  /// The number of deepest cells in it.
  std::uint32_t span() const { return std::uint32_t(1) << 3 * (deepestCell - depth); }

  /// Not for a deepest cell; number is 0 to 7, with bits for the upper half along x, y, z.
  CellCode child(std::uint32_t number) const {
    const auto below = std::uint8_t(depth + 1);
    return {first + (number << 3 * (deepestCell - below)), below};
  }

  /// Of its lower corner, in edges of the deepest cells.
  glm::uvec3 coordinates() const {
    return {gatherBits(first), gatherBits(first >> 1), gatherBits(first >> 2)};
  }

  bool operator==(const CellCode&) const = default;
};

/// The deepest cell at coordinates below 1024.
inline CellCode deepestCellAt(const glm::uvec3& coordinates) {
  return {
      spreadBits(coordinates.x) | spreadBits(coordinates.y) << 1 | spreadBits(coordinates.z) << 2,
      deepestCell};
}

}  // namespace haarlight
