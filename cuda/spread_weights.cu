// Weights of squares become weights of texels (src/engine/square_weights.h), for one lobe per sample
// number: that of slots[i] goes to places[i]. Out: row · 96 + channel · 32 + column. The scalar twin
// is spreadOverTexels(). A lane takes every 32nd block of 4x4 texels.

__device__ inline uint onQuarter(uint4 weight, uint right, uint bottom) {
  const uint horizontal = right ? 0u - weight.x : weight.x,
             vertical = bottom ? 0u - weight.y : weight.y,
             diagonal = right ^ bottom ? 0u - weight.z : weight.z;
  return (weight.w + horizontal) + (vertical + diagonal);
}

// Weight of a square of the list in one quarter of it; 0 where the list has no such square.
__device__ inline uint weightOn(const uint4* weights, uint square, uint right, uint bottom) {
  return square == ABSENT_SQUARE ? 0 : onQuarter(weights[3 * square], right, bottom);
}

// What the squares of levels 0 … 2 give a block.
__device__ inline uint coarseWeight(const uint4* weights, uint face, uint x, uint y) {
  const uint4* own = weights + 3 * face * COARSE_MEANS;
  const uint second = 1 + (y >> 2) * 2 + (x >> 2), third = 5 + (y >> 1) * 4 + (x >> 1);
  return onQuarter(own[0], x >> 2, y >> 2) +
         onQuarter(own[3 * second], x >> 1 & 1, y >> 1 & 1) +
         onQuarter(own[3 * third], x & 1, y & 1);
}

// The texels of a block that no finer square of the list lies in.
__device__ inline void fillBlock(uint weight, uint* texels) {
  for (uint row = 0; row < 4; ++row)
    for (uint column = 0; column < 4; ++column) texels[row * 3 * FACE_SIZE + column] = weight;
}

// The texels of any block. `squares` are its own square and its quarters'.
__device__ inline void spreadBlock(const uint4* weights, const uint* squares, uint coarse,
                        uint* texels) {
  for (uint quarter = 0; quarter < 4; ++quarter) {
    const uint right = quarter & 1, bottom = quarter >> 1;
    const uint base = coarse + weightOn(weights, squares[0], right, bottom);
    for (uint texel = 0; texel < 4; ++texel)
      texels[(2 * bottom + (texel >> 1)) * 3 * FACE_SIZE + 2 * right + (texel & 1)] =
          base + weightOn(weights, squares[1 + quarter], texel & 1, texel >> 1);
  }
}

// Whether the list has the block's square or one of its quarters.
__device__ inline bool hasFineSquares(const uint* squares) {
  uint smallest = ABSENT_SQUARE;
  for (uint i = 0; i < 5; ++i) smallest = min(smallest, squares[i]);
  return smallest != ABSENT_SQUARE;
}

// A block in all channels.
__device__ inline void spreadChannels(const uint4* weights, const uint* blockSquares, uint block,
                           uint* texelWeights) {
  const uint face = block / BLOCKS_PER_FACE, place = block % BLOCKS_PER_FACE;
  const uint x = place % BLOCKS_PER_SIDE, y = place / BLOCKS_PER_SIDE;
  const uint* squares = blockSquares + 5 * block;
  const bool isFine = hasFineSquares(squares);
  for (uint channel = 0; channel < 3; ++channel) {
    const uint coarse = coarseWeight(weights + channel, face, x, y);
    uint* texels =
        texelWeights + ((face * FACE_SIZE + 4 * y) * 3 + channel) * FACE_SIZE + 4 * x;
    if (isFine)
      spreadBlock(weights + channel, squares, coarse, texels);
    else
      fillBlock(coarse, texels);
  }
}

HAARLIGHT_KERNEL void spreadWeights(const uint* __restrict__ slots,
                                    const uint* __restrict__ places, const uint squareCount,
                                    const uint4* __restrict__ weights,
                                    const uint* __restrict__ blockSquares,
                                    uint* __restrict__ texelWeights) {
  const uint4* own = weights + size_t(3) * squareCount * slots[SAMPLE];
  uint* texels = texelWeights + size_t(TEXEL_WEIGHTS) * places[SAMPLE];
  for (uint block = LANE; block < BLOCKS; block += LANES)
    spreadChannels(own, blockSquares, block, texels);
}
