#include "haar/occlusion_transform.h"

#include "haar/transform.h"

namespace haarlight {

namespace {

std::array<float, 4> quarterPixels(int block, int quarter) {
  const int row = 2 * (quarter / 2), column = 2 * (quarter % 2);
  std::array<float, 4> pixels;
  for (int i = 0; i < 4; ++i) pixels[i] = float(block >> (4 * (row + i / 2) + column + i % 2) & 1);
  return pixels;
}

void transformBlock(int block, float* entry) {
  std::array<float, 4> quarterMeans;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto [a, b, c, d] = quarterPixels(block, quarter);
    const auto fine = squareCoefficients<float, float>(4, a, b, c, d);
    for (int type = 0; type < 3; ++type) entry[4 + 3 * quarter + type] = fine[type];
    quarterMeans[quarter] = (a + b + c + d) * 0.25f;
  }
  const auto [a, b, c, d] = quarterMeans;
  const auto coarse = squareCoefficients<float, float>(3, a, b, c, d);
  entry[0] = (a + b + c + d) * 0.25f;
  for (int type = 0; type < 3; ++type) entry[1 + type] = coarse[type];
}

const float* blockEntry(std::uint16_t block) {
  return &blockTable()[std::size_t(block) * blockTableStride];
}

std::uint16_t blockBits(const BitCube& cube, int face, int block) {
  const int top = face * faceSize + 4 * (block / blocksPerSide),
            shift = 4 * (block % blocksPerSide);
  std::uint16_t bits = 0;
  for (int row = 0; row < 4; ++row) bits |= (cube.rows[top + row] >> shift & 15u) << (4 * row);
  return bits;
}

/// Levels 2, 1, 0 of a face from its 8×8 block means.
void transformFace(std::span<const float> blockMeans, float* coefficients, float* means) {
  std::span<const float> finer = blockMeans;
  for (int level = coarseLevels - 1; level >= 0; --level) {
    for (int square = 0; square < squaresPerSide(level) * squaresPerSide(level); ++square) {
      const auto [a, b, c, d] = children(level, square);
      const auto triple =
          squareCoefficients<float, float>(level, finer[a], finer[b], finer[c], finer[d]);
      for (int type = 0; type < 3; ++type)
        coefficients[coefficientIndex(level, square, type)] = triple[type];
      means[meanIndex(level, square)] = ((finer[a] + finer[b]) + (finer[c] + finer[d])) * 0.25f;
    }
    finer = {means + firstMean(level), std::size_t(firstCoefficient(level))};
  }
  coefficients[0] = means[0];
}

}  // namespace

const std::vector<float>& blockTable() {
  static const auto table = [] {
    std::vector<float> entries(65536 * blockTableStride);
    for (int block = 0; block < 65536; ++block)
      transformBlock(block, &entries[std::size_t(block) * blockTableStride]);
    return entries;
  }();
  return table;
}

SquareValues blockValues(std::uint16_t block) {
  const float* entry = blockEntry(block);
  return {entry[1], entry[2], entry[3], entry[0]};
}

SquareValues quarterValues(std::uint16_t block, int quarter) {
  const float* entry = blockEntry(block);
  const float* fine = entry + 4 + 3 * quarter;
  float signedSum = 0;
  for (int type = 0; type < 3; ++type)
    signedSum += float(waveletSign(type, quarter)) * entry[1 + type];
  return {fine[0], fine[1], fine[2], entry[0] + float(squaresPerSide(3)) * signedSum};
}

OcclusionHaar transformOcclusion(const BitCube& cube) {
  OcclusionHaar occlusion;
  for (int face = 0; face < faceCount; ++face) {
    std::array<float, blocksPerFace> blockMeans;
    for (int block = 0; block < blocksPerFace; ++block) {
      const std::uint16_t bits = blockBits(cube, face, block);
      occlusion.blocks[face * blocksPerFace + block] = bits;
      blockMeans[block] = blockEntry(bits)[0];
    }
    transformFace(blockMeans, &occlusion.coefficients[face * coarseCoefficientsPerFace],
                  &occlusion.means[face * coarseMeansPerFace]);
  }
  return occlusion;
}

}  // namespace haarlight
