// Step 2: the Haar transform of a sample's bit cube (paper §3.4). Layouts: src/haar/basis.h and
// src/haar/occlusion_transform.h. Everything here is exact in float32.

// One square of a level from the means a b / c d of its quarters; returns its own.
__device__ inline float transformSquare(const float* finer, uint level, uint square,
                                        float* coefficients) {
  const uint side = 1u << level;
  const uint above = 4 * side * (square / side) + 2 * (square % side), below = above + 2 * side;
  const float a = finer[above], b = finer[above + 1], c = finer[below], d = finer[below + 1];
  const float scale = 0.0625f * float(4u >> level);  // 2^-level / 4, no quotient
  float* triple = coefficients + (1u << 2 * level) + 3 * square;
  triple[0] = ((a - b) + (c - d)) * scale;
  triple[1] = ((a + b) - (c + d)) * scale;
  triple[2] = ((a - b) - (c - d)) * scale;
  return ((a + b) + (c + d)) * 0.25f;
}

// One level of all six faces. `finer` and `coarser` hold the means of all faces, face by face.
__device__ inline void transformLevel(uint level, const float* finer, float* coarser,
                                      float* coefficients, float* means) {
  const uint squares = 1u << 2 * level, total = FACES * squares;
  for (uint index = LANE; index < total; index += LANES) {
    const uint face = index / squares, square = index % squares;
    coarser[index] = transformSquare(finer + face * 4 * squares, level, square,
                                     coefficients + face * COARSE_COEFFICIENTS);
    means[face * COARSE_MEANS + (squares - 1) / 3 + square] = coarser[index];
    if (level == 0) coefficients[face * COARSE_COEFFICIENTS] = coarser[index];
  }
  LANE_BARRIER();
}

// Number of set bits among 16, by adding neighbours.
__device__ inline uint blockBitCount(uint bits) {
  uint count = bits - (bits >> 1 & 0x5555u);
  count = (count & 0x3333u) + (count >> 2 & 0x3333u);
  count = (count + (count >> 4)) & 0x0f0fu;
  return (count + (count >> 8)) & 0x1fu;
}

// Bits of a block: bit 4 * row + column.
__device__ inline uint blockBits(const uint* bitCube, uint block) {
  const uint face = block / BLOCKS_PER_FACE, place = block % BLOCKS_PER_FACE;
  const uint* rows = bitCube + face * FACE_SIZE + 4 * (place / BLOCKS_PER_SIDE);
  const uint shift = 4 * (place % BLOCKS_PER_SIDE);
  return (rows[0] >> shift & 15u) | (rows[1] >> shift & 15u) << 4 |
         (rows[2] >> shift & 15u) << 8 | (rows[3] >> shift & 15u) << 12;
}

__device__ inline void findBlocks(const uint* bitCube, ushort* blocks, float* means) {
  for (uint block = LANE; block < BLOCKS; block += LANES) {
    const uint bits = blockBits(bitCube, block);
    blocks[block] = ushort(bits);
    means[block] = 0.0625f * float(blockBitCount(bits));
  }
}

HAARLIGHT_KERNEL void transformOcclusion(const uint* __restrict__ bitCubes,
                                         float* __restrict__ coefficients,
                                         float* __restrict__ means,
                                         ushort* __restrict__ blocks) {
  SAMPLE_LOCAL(float, meansOfLevel3, FACES * 64);
  SAMPLE_LOCAL(float, meansOfLevel2, FACES * 16);
  SAMPLE_LOCAL(float, meansOfLevel1, FACES * 4);
  SAMPLE_LOCAL(float, meansOfLevel0, FACES);
  const size_t sample = SAMPLE;
  const uint* bitCube = bitCubes + sample * BIT_CUBE_ROWS;
  float* ownCoefficients = coefficients + sample * FACES * COARSE_COEFFICIENTS;
  float* ownMeans = means + sample * FACES * COARSE_MEANS;

  findBlocks(bitCube, blocks + sample * BLOCKS, meansOfLevel3);
  LANE_BARRIER();

  transformLevel(2, meansOfLevel3, meansOfLevel2, ownCoefficients, ownMeans);
  transformLevel(1, meansOfLevel2, meansOfLevel1, ownCoefficients, ownMeans);
  transformLevel(0, meansOfLevel1, meansOfLevel0, ownCoefficients, ownMeans);
}
