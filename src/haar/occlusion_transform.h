#pragma once

/// The Haar transform of a sample's occlusion, straight from its bit cube (method.md §4, paper
/// §3.4).
///
/// Occlusion is O = 1 − V: 1 where the bit is set. Its coefficients are those of V with the sign
/// turned and its means are 1 − those of V; the triple product uses O (see
/// engine/shading_tables.h). For a 0/1 image every mean and coefficient is a dyadic rational with
/// few digits: exact in float32 whatever the order of operations.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cube/bit_cube.h"
#include "haar/basis.h"

namespace haarlight {

/// 4×4 blocks per side of a face, and in all.
inline constexpr int blocksPerSide = faceSize / 4;
inline constexpr int blocksPerFace = blocksPerSide * blocksPerSide;
inline constexpr int blockCount = faceCount * blocksPerFace;

/// A sample's occlusion in the Haar basis: the 8×8 part of each face is stored (levels 0 … 2),
/// levels 3 and 4 are found in the block table by the bits of each block (levels I and II of the
/// paper).
struct OcclusionHaar {
  /// face · 64 + coefficient index.
  std::array<float, faceCount * coarseCoefficientsPerFace> coefficients;
  /// face · 21 + mean index.
  std::array<float, faceCount * coarseMeansPerFace> means;
  /// face · 64 + block row · 8 + block column: the block's 16 bits; bit 4·row + column of the
  /// block.
  std::array<std::uint16_t, blockCount> blocks;

  bool operator==(const OcclusionHaar&) const = default;
};

/// Transforms of all 65,536 blocks of 4×4 bits, 16 floats each: the mean, the three coefficients of
/// level 3, and the twelve of level 4 (3 · quarter + type, quarters in the order of children()).
inline constexpr int blockTableStride = 16;
const std::vector<float>& blockTable();

/// The three level-4 or level-3 coefficients and the mean over one square of a block.
struct SquareValues {
  float horizontal, vertical, diagonal, mean;
};

/// Level 3: the whole block.
SquareValues blockValues(std::uint16_t block);

/// Level 4: one quarter. Its mean follows from the block's by the paper's psum recursion.
SquareValues quarterValues(std::uint16_t block, int quarter);

/// Transforms a bit cube: block bits, block means by table, 8×8 pyramid by the ordinary transform.
OcclusionHaar transformOcclusion(const BitCube& cube);

}  // namespace haarlight
