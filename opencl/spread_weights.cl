// Weights of squares become weights of texels (src/engine/square_weights.h), for one lobe per sample
// number: its slot stands in `slots`. Out: row · 96 + channel · 32 + column. The scalar twin is
// spreadOverTexels(). A lane takes every 32nd block of 4x4 texels.

inline uint onQuarter(uint4 weight, uint right, uint bottom) {
  const uint horizontal = right ? -weight.x : weight.x, vertical = bottom ? -weight.y : weight.y,
             diagonal = right ^ bottom ? -weight.z : weight.z;
  return (weight.w + horizontal) + (vertical + diagonal);
}

// Weight of a square of the list in one quarter of it; 0 where the list has no such square.
inline uint weightOn(__global const uint4* weights, uint square, uint right, uint bottom) {
  return square == ABSENT_SQUARE ? 0 : onQuarter(weights[3 * square], right, bottom);
}

// What the squares of levels 0 … 2 give a block.
inline uint coarseWeight(__global const uint4* weights, uint face, uint x, uint y) {
  __global const uint4* own = weights + 3 * face * COARSE_MEANS;
  const uint second = 1 + (y >> 2) * 2 + (x >> 2), third = 5 + (y >> 1) * 4 + (x >> 1);
  return onQuarter(own[0], x >> 2, y >> 2) +
         onQuarter(own[3 * second], x >> 1 & 1, y >> 1 & 1) +
         onQuarter(own[3 * third], x & 1, y & 1);
}

// The texels of a block, of one channel.
inline void spreadBlock(__global const uint4* weights, __global const uint* squares, uint block,
                        __global uint* texels) {
  const uint face = block / BLOCKS_PER_FACE, place = block % BLOCKS_PER_FACE;
  const uint x = place % BLOCKS_PER_SIDE, y = place / BLOCKS_PER_SIDE;
  const uint coarse = coarseWeight(weights, face, x, y);
  for (uint quarter = 0; quarter < 4; ++quarter) {
    const uint right = quarter & 1, bottom = quarter >> 1;
    const uint base = coarse + weightOn(weights, squares[5 * block], right, bottom);
    for (uint texel = 0; texel < 4; ++texel) {
      const uint column = 4 * x + 2 * right + (texel & 1),
                 row = face * FACE_SIZE + 4 * y + 2 * bottom + (texel >> 1);
      texels[row * 3 * FACE_SIZE + column] =
          base + weightOn(weights, squares[5 * block + 1 + quarter], texel & 1, texel >> 1);
    }
  }
}

HAARLIGHT_KERNEL void spreadWeights(__global const uint* restrict slots, const uint squareCount,
                                    __global const uint4* restrict weights,
                                    __global const uint* restrict blockSquares,
                                    __global uint* restrict texelWeights) {
  __global const uint4* own = weights + (size_t)3 * squareCount * slots[SAMPLE];
  __global uint* texels = texelWeights + SAMPLE * TEXEL_WEIGHTS;
  for (uint first = 0; first < BLOCKS; first += LANES)
    FOR_EACH_LANE(lane)
      for (uint channel = 0; channel < 3; ++channel)
        spreadBlock(own + channel, blockSquares, first + lane, texels + channel * FACE_SIZE);
}
