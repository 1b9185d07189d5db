// Step 2: the Haar transform of a sample's bit cube (paper §3.4). Layouts: src/haar/basis.h and
// src/haar/occlusion_transform.h. Everything here is exact in float32.

// One square of a level from the means a b / c d of its quarters.
inline void transformSquare(__local const float* finer, uint level, uint square,
                            __global float* coefficients, __local float* mean) {
  const uint side = 1u << level;
  const uint above = 4 * side * (square / side) + 2 * (square % side), below = above + 2 * side;
  const float a = finer[above], b = finer[above + 1], c = finer[below], d = finer[below + 1];
  const float scale = 0.0625f * (float)(4u >> level);  // 2^-level / 4, no quotient
  __global float* triple = coefficients + (1u << 2 * level) + 3 * square;
  triple[0] = ((a - b) + (c - d)) * scale;
  triple[1] = ((a + b) - (c + d)) * scale;
  triple[2] = ((a - b) - (c - d)) * scale;
  *mean = ((a + b) + (c + d)) * 0.25f;
}

// One level of all six faces. `finer` and `coarser` hold the means of all faces, face by face.
inline void transformLevel(uint level, __local const float* finer, __local float* coarser,
                           __global float* coefficients, __global float* means) {
  const uint squares = 1u << 2 * level, total = FACES * squares;
  for (uint first = 0; first < total; first += LANES)
    FOR_EACH_LANE(lane) {
      const uint index = first + lane, face = index / squares, square = index % squares;
      if (index >= total) continue;
      transformSquare(finer + face * 4 * squares, level, square,
                      coefficients + face * COARSE_COEFFICIENTS, coarser + index);
      means[face * COARSE_MEANS + (squares - 1) / 3 + square] = coarser[index];
      if (level == 0) coefficients[face * COARSE_COEFFICIENTS] = coarser[index];
    }
  LANE_BARRIER();
}

// Bits of a block: bit 4 * row + column.
inline uint blockBits(__global const uint* bitCube, uint block) {
  const uint face = block / BLOCKS_PER_FACE, place = block % BLOCKS_PER_FACE;
  __global const uint* rows = bitCube + face * FACE_SIZE + 4 * (place / BLOCKS_PER_SIDE);
  const uint shift = 4 * (place % BLOCKS_PER_SIDE);
  return (rows[0] >> shift & 15u) | (rows[1] >> shift & 15u) << 4 |
         (rows[2] >> shift & 15u) << 8 | (rows[3] >> shift & 15u) << 12;
}

HAARLIGHT_KERNEL void transformOcclusion(__global const uint* restrict bitCubes,
                                         __global const float* restrict blockTable,
                                         __global float* restrict coefficients,
                                         __global float* restrict means,
                                         __global ushort* restrict blocks) {
  SAMPLE_LOCAL(float, meansOfLevel3, FACES * 64);
  SAMPLE_LOCAL(float, meansOfLevel2, FACES * 16);
  SAMPLE_LOCAL(float, meansOfLevel1, FACES * 4);
  SAMPLE_LOCAL(float, meansOfLevel0, FACES);
  const size_t sample = SAMPLE;
  __global const uint* bitCube = bitCubes + sample * BIT_CUBE_ROWS;
  __global float* ownCoefficients = coefficients + sample * FACES * COARSE_COEFFICIENTS;
  __global float* ownMeans = means + sample * FACES * COARSE_MEANS;

  for (uint first = 0; first < BLOCKS; first += LANES)
    FOR_EACH_LANE(lane) {
      const uint bits = blockBits(bitCube, first + lane);
      blocks[sample * BLOCKS + first + lane] = (ushort)bits;
      meansOfLevel3[first + lane] = blockTable[bits * BLOCK_TABLE_STRIDE];
    }
  LANE_BARRIER();

  transformLevel(2, meansOfLevel3, meansOfLevel2, ownCoefficients, ownMeans);
  transformLevel(1, meansOfLevel2, meansOfLevel1, ownCoefficients, ownMeans);
  transformLevel(0, meansOfLevel1, meansOfLevel0, ownCoefficients, ownMeans);
}
