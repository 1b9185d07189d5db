#pragma once

#include <array>
#include <cstdint>

#include "cube/cube_map.h"

namespace haarlight {

/// Rows of all faces: word face·32 + row holds a row of texels.
inline constexpr int bitCubeRows = faceCount * faceSize;

/// One bit per texel of the cube, set where the texel is blocked (method.md §3). Bit c (counted
/// from the least significant) of a word is column c.
struct BitCube {
  std::array<std::uint32_t, bitCubeRows> rows{};

  bool blocked(int texel) const { return rows[texel / faceSize] >> (texel % faceSize) & 1; }

  BitCube& operator|=(const BitCube& other) {
    for (int row = 0; row < bitCubeRows; ++row) rows[row] |= other.rows[row];
    return *this;
  }
  bool operator==(const BitCube&) const = default;
};
static_assert(sizeof(BitCube) == 768);

}  // namespace haarlight
