// Step 2: the Haar transform of a sample's bit cube (paper §3.4). Layouts: src/haar/basis.h and
// src/haar/occlusion_transform.h. Everything here is exact in float32.

// One square of a level from the means a b / c d of its quarters; returns its own.
inline float transformSquare(__local const float* finer, uint level, uint square,
                             __global float* coefficients) {
  const uint side = 1u << level;
  const uint above = 4 * side * (square / side) + 2 * (square % side), below = above + 2 * side;
  const float a = finer[above], b = finer[above + 1], c = finer[below], d = finer[below + 1];
  const float scale = 0.0625f * (float)(4u >> level);  // 2^-level / 4, no quotient
  __global float* triple = coefficients + (1u << 2 * level) + 3 * square;
  triple[0] = ((a - b) + (c - d)) * scale;
  triple[1] = ((a + b) - (c + d)) * scale;
  triple[2] = ((a - b) - (c - d)) * scale;
  return ((a + b) + (c + d)) * 0.25f;
}

#if LANES_PER_ITEM == 1
// One level of all six faces. `finer` and `coarser` hold the means of all faces, face by face.
inline void transformLevel(uint level, __local const float* finer, __local float* coarser,
                           __global float* coefficients, __global float* means) {
  const uint squares = 1u << 2 * level, total = FACES * squares;
  for (uint first = 0; first < total; first += LANES)
    FOR_EACH_LANE(lane) {
      const uint index = first + lane, face = index / squares, square = index % squares;
      if (index >= total) continue;
      coarser[index] = transformSquare(finer + face * 4 * squares, level, square,
                                       coefficients + face * COARSE_COEFFICIENTS);
      means[face * COARSE_MEANS + (squares - 1) / 3 + square] = coarser[index];
      if (level == 0) coefficients[face * COARSE_COEFFICIENTS] = coarser[index];
    }
  LANE_BARRIER();
}
#else
// Four squares from the means of their quarters, which lie side by side in `upper` and `lower`, those
// of the last two squares from `third` on. Their triples follow each other in `triples`.
inline float4 transformSquares(__local const float* upper, __local const float* lower, uint third,
                               float scale, __global float* triples) {
  const float4 a = (float4)(upper[0], upper[2], upper[third], upper[third + 2]),
               b = (float4)(upper[1], upper[3], upper[third + 1], upper[third + 3]),
               c = (float4)(lower[0], lower[2], lower[third], lower[third + 2]),
               d = (float4)(lower[1], lower[3], lower[third + 1], lower[third + 3]);
  const float4 horizontal = ((a - b) + (c - d)) * scale, vertical = ((a + b) - (c + d)) * scale,
               diagonal = ((a - b) - (c - d)) * scale;
  vstore4((float4)(horizontal.x, vertical.x, diagonal.x, horizontal.y), 0, triples);
  vstore4((float4)(vertical.y, diagonal.y, horizontal.z, vertical.z), 1, triples);
  vstore4((float4)(diagonal.z, horizontal.w, vertical.w, diagonal.w), 2, triples);
  return ((a + b) + (c + d)) * 0.25f;
}

// One level of all six faces, in vectors of squares. `finer` and `coarser` hold the means of all
// faces, face by face.
inline void transformLevel(uint level, __local const float* finer, __local float* coarser,
                           __global float* coefficients, __global float* means) {
  for (uint face = 0; face < FACES; ++face) {
    __global float* faceCoefficients = coefficients + face * COARSE_COEFFICIENTS;
    __global float* faceMeans = means + face * COARSE_MEANS;
    if (level == 2) {  // a row of four squares lies under two rows of eight
      for (uint row = 0; row < 4; ++row) {
        __local const float* upper = finer + 16 * (4 * face + row);
        const float4 mean = transformSquares(upper, upper + 8, 4, 0.0625f,
                                             faceCoefficients + 16 + 12 * row);
        vstore4(mean, 4 * face + row, coarser);
        vstore4(mean, row, faceMeans + 5);
      }
    } else if (level == 1) {
      __local const float* upper = finer + 16 * face;
      const float4 mean = transformSquares(upper, upper + 4, 8, 0.125f, faceCoefficients + 4);
      vstore4(mean, face, coarser);
      vstore4(mean, 0, faceMeans + 1);
    } else {
      faceMeans[0] = transformSquare(finer + 4 * face, 0, 0, faceCoefficients);
      faceCoefficients[0] = faceMeans[0];
    }
  }
}
#endif

// Number of set bits among the 16 of every element, by adding neighbours.
inline LaneUint blockBitCount(LaneUint bits) {
  LaneUint count = bits - (bits >> 1 & 0x5555u);
  count = (count & 0x3333u) + (count >> 2 & 0x3333u);
  count = (count + (count >> 4)) & 0x0f0fu;
  return (count + (count >> 8)) & 0x1fu;
}

#if LANES_PER_ITEM == 1
// Bits of a block: bit 4 * row + column.
inline uint blockBits(__global const uint* bitCube, uint block) {
  const uint face = block / BLOCKS_PER_FACE, place = block % BLOCKS_PER_FACE;
  __global const uint* rows = bitCube + face * FACE_SIZE + 4 * (place / BLOCKS_PER_SIDE);
  const uint shift = 4 * (place % BLOCKS_PER_SIDE);
  return (rows[0] >> shift & 15u) | (rows[1] >> shift & 15u) << 4 |
         (rows[2] >> shift & 15u) << 8 | (rows[3] >> shift & 15u) << 12;
}

inline void findBlocks(__global const uint* bitCube, __global ushort* blocks,
                       __local float* means) {
  for (uint first = 0; first < BLOCKS; first += LANES)
    FOR_EACH_LANE(lane) {
      const uint bits = blockBits(bitCube, first + lane);
      blocks[first + lane] = (ushort)bits;
      means[first + lane] = 0.0625f * (float)blockBitCount(bits);
    }
}
#else
// A work-item with all lanes takes two rows of eight blocks at a time, so that no lane has to gather.
inline void findBlocks(__global const uint* bitCube, __global ushort* blocks,
                       __local float* means) {
  const uint16 shift = (uint16)(0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28);
  const int16 second = (int16)(0, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1, -1, -1, -1, -1, -1);
  for (uint pair = 0; pair < BLOCKS / 16; ++pair) {
    const uint8 rows = vload8(pair, bitCube);
#define BITS_OF_ROW(first, other) (select((uint16)(first), (uint16)(other), second) >> shift & 15u)
    const uint16 row0 = BITS_OF_ROW(rows.s0, rows.s4), row1 = BITS_OF_ROW(rows.s1, rows.s5),
                 row2 = BITS_OF_ROW(rows.s2, rows.s6), row3 = BITS_OF_ROW(rows.s3, rows.s7);
#undef BITS_OF_ROW
    const uint16 bits = row0 | row1 << 4 | row2 << 8 | row3 << 12;
    vstore16(convert_ushort16(bits), pair, blocks);
    vstore16(0.0625f * convert_float16(blockBitCount(bits)), pair, means);
  }
}
#endif

HAARLIGHT_KERNEL void transformOcclusion(__global const uint* restrict bitCubes,
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

  findBlocks(bitCube, blocks + sample * BLOCKS, meansOfLevel3);
  LANE_BARRIER();

  transformLevel(2, meansOfLevel3, meansOfLevel2, ownCoefficients, ownMeans);
  transformLevel(1, meansOfLevel2, meansOfLevel1, ownCoefficients, ownMeans);
  transformLevel(0, meansOfLevel1, meansOfLevel0, ownCoefficients, ownMeans);
}
