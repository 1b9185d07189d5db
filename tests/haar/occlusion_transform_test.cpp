#include "haar/occlusion_transform.h"

#include <doctest/doctest.h>

#include <random>

#include "haar/transform.h"

using namespace haarlight;

namespace {

BitCube randomCube(int seed) {
  std::mt19937 random(seed);
  BitCube cube;
  for (auto& row : cube.rows) row = random() & random();
  return cube;
}

std::vector<float> faceTexels(const BitCube& cube, int face) {
  std::vector<float> texels(texelsPerFace);
  for (int i = 0; i < texelsPerFace; ++i) texels[i] = float(cube.blocked(face * texelsPerFace + i));
  return texels;
}

/// Block (0, 0) of an otherwise empty face, transformed by the general transform.
HaarFace<double> transformWholeFace(int block) {
  std::vector<double> texels(texelsPerFace);
  for (int bit = 0; bit < 16; ++bit) texels[bit / 4 * faceSize + bit % 4] = block >> bit & 1;
  return haarForward<double, double>(texels);
}

}  // namespace

TEST_CASE("the table holds the definition's coefficients of all 65,536 blocks, bit for bit") {
  for (int block = 0; block < 65536; ++block) {
    const auto face = transformWholeFace(block);
    const float* entry = &blockTable()[std::size_t(block) * blockTableStride];
    REQUIRE(double(entry[0]) == face.mean(3, 0));
    for (int type = 0; type < 3; ++type)
      REQUIRE(double(entry[1 + type]) == face.coefficient({3, 0, type}));
    for (int quarter = 0; quarter < 4; ++quarter) {
      const int square = children(3, 0)[quarter];
      for (int type = 0; type < 3; ++type)
        REQUIRE(double(entry[4 + 3 * quarter + type]) == face.coefficient({4, square, type}));
    }
  }
}

TEST_CASE("the paper's example block 0x7310 is the picture 0111 0011 0001 0000") {
  // The paper writes rows top to bottom with the leftmost texel as the highest bit; here the
  // leftmost texel is the lowest bit, so the same picture has the reversed bits, 0x08CE.
  const float* entry = &blockTable()[0x08CE * blockTableStride];
  CHECK(entry[0] == 6.0f / 16);
  CHECK(entry[1] == 0.25f / 8 * (0.25f - 1.0f + 0.0f - 0.25f));  // quarters ¼ 1 / 0 ¼
  CHECK(entry[2] == 0.25f / 8 * (0.25f + 1.0f - 0.0f - 0.25f));
  CHECK(entry[3] == 0.25f / 8 * (0.25f - 1.0f - 0.0f + 0.25f));
}

TEST_CASE("the quarter's mean by the psum recursion is its mean") {
  for (int block = 0; block < 65536; block += 7)
    for (int quarter = 0; quarter < 4; ++quarter) {
      int set = 0;
      for (int i = 0; i < 4; ++i)
        set += block >> (4 * (2 * (quarter / 2) + i / 2) + 2 * (quarter % 2) + i % 2) & 1;
      REQUIRE(quarterValues(std::uint16_t(block), quarter).mean == set / 4.0f);
    }
}

TEST_CASE("a bit cube's transform equals the general transform of its texels, bit for bit") {
  for (int seed = 0; seed < 20; ++seed) {
    const BitCube cube = randomCube(seed);
    const OcclusionHaar occlusion = transformOcclusion(cube);
    for (int face = 0; face < faceCount; ++face) {
      const auto expected = haarForward<float, float>(faceTexels(cube, face));
      for (int i = 0; i < coarseCoefficientsPerFace; ++i)
        REQUIRE(occlusion.coefficients[face * coarseCoefficientsPerFace + i] ==
                expected.coefficients[i]);
      for (int i = 0; i < coarseMeansPerFace; ++i)
        REQUIRE(occlusion.means[face * coarseMeansPerFace + i] == expected.means[i]);
      for (int square = 0; square < blocksPerFace; ++square) {
        const auto bits = occlusion.blocks[face * blocksPerFace + square];
        const SquareValues values = blockValues(bits);
        REQUIRE(values.horizontal == expected.coefficient({3, square, 0}));
        REQUIRE(values.vertical == expected.coefficient({3, square, 1}));
        REQUIRE(values.diagonal == expected.coefficient({3, square, 2}));
        for (int quarter = 0; quarter < 4; ++quarter) {
          const int fine = children(3, square)[quarter];
          const SquareValues fineValues = quarterValues(bits, quarter);
          REQUIRE(fineValues.horizontal == expected.coefficient({4, fine, 0}));
          REQUIRE(fineValues.vertical == expected.coefficient({4, fine, 1}));
          REQUIRE(fineValues.diagonal == expected.coefficient({4, fine, 2}));
          REQUIRE(fineValues.mean == expected.mean(4, fine));
        }
      }
    }
  }
}
