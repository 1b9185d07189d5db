// Step 3: the triple product of light, occlusion and lobe, as weights of squares
// (src/engine/square_weights.h); the scalar twin is src/engine/reference/sample_shader.h. A lane takes
// every 32nd square; lists are padded to multiples of 32 with weights of zero.

// A sample's occlusion in the Haar basis.
struct Occlusion {
  const float* coefficients;
  const float* means;
  const ushort* blocks;
};

// Numbers of blocked texels by sign, of the numbers in the quarters a b / c d.
__device__ inline uint4 bySign(uint a, uint b, uint c, uint d) {
  return make_uint4((a - b) + (c - d), (a + b) - (c + d), (a - b) - (c - d), (a + b) + (c + d));
}

// Coefficients times 2^(10 - l) and the mean times 2^(10 - 2l) are integers. Squares of a face are
// numbered as their means are; the coefficients of square i begin at 3i + 1.
__device__ inline uint4 coarseNumbers(const Occlusion* occlusion, uint square) {
  const uint place = min(square, uint(FACES * COARSE_MEANS - 1));
  const uint face = place / COARSE_MEANS, index = place % COARSE_MEANS;
  const uint level = (index > 0 ? 1 : 0) + (index > 4 ? 1 : 0);
  const float* first = occlusion->coefficients + face * COARSE_COEFFICIENTS + 3 * index + 1;
  const float coefficient = float(1024u >> level), mean = float(1024u >> 2 * level);
  return make_uint4(uint(int(first[0] * coefficient)), uint(int(first[1] * coefficient)),
                    uint(int(first[2] * coefficient)), uint(occlusion->means[place] * mean));
}

// A block's bits are 4 * row + column.
__device__ inline uint4 blockNumbers(const Occlusion* occlusion, uint block) {
  const uint bits = occlusion->blocks[block];
  const uint pairs = bits - (bits >> 1 & 0x5555u);  // of neighbours in a row, two bits each
  return bySign((pairs & 3) + (pairs >> 4 & 3), (pairs >> 2 & 3) + (pairs >> 6 & 3),
                (pairs >> 8 & 3) + (pairs >> 12 & 3), (pairs >> 10 & 3) + (pairs >> 14 & 3));
}

__device__ inline uint4 quarterNumbers(const Occlusion* occlusion, uint place) {
  const uint bits = occlusion->blocks[place / 4] >> (8 * (place >> 1 & 1) + 2 * (place & 1));
  return bySign(bits & 1, bits >> 1 & 1, bits >> 4 & 1, bits >> 5 & 1);
}

__device__ inline uint dotNumbers(uint4 weight, uint4 numbers) {
  return (weight.x * numbers.x + weight.y * numbers.y) +
         (weight.z * numbers.z + weight.w * numbers.w);
}

#define ADD_SQUARES(begin, end, numbersOn)                                              \
  for (uint square = (begin) + LANE; square < (end); square += LANES) {                 \
    const uint4 numbers = numbersOn;                                                    \
    for (uint i = 0; i < blend.count; ++i) {                                            \
      const uint4* rows = weights + 3 * (blend.slots[i] * squares.z + square);          \
      sums[i].x += dotNumbers(rows[0], numbers);                                        \
      sums[i].y += dotNumbers(rows[1], numbers);                                        \
      sums[i].z += dotNumbers(rows[2], numbers);                                        \
    }                                                                                   \
  }

HAARLIGHT_KERNEL void tripleProduct(const float* __restrict__ coefficients,
                                    const float* __restrict__ means,
                                    const ushort* __restrict__ blocks,
                                    const LobeBlend* __restrict__ receivers,
                                    const uint lobesPerReceiver,
                                    const uint* __restrict__ lobeSlots,
                                    const uint4 squares,
                                    const uint* __restrict__ places,
                                    const uint4* __restrict__ weights,
                                    const uint4* __restrict__ unshadowed,
                                    const float4* __restrict__ scales,
                                    float4* __restrict__ radiance) {
  SAMPLE_LOCAL(uint, partials, LOBE_SUMS * LANES);
  const size_t sample = SAMPLE;
  const Occlusion occlusion = {coefficients + sample * FACES * COARSE_COEFFICIENTS,
                               means + sample * FACES * COARSE_MEANS, blocks + sample * BLOCKS};
  const Blend blend = blendOf(receivers[sample], lobesPerReceiver, lobeSlots);

  uint4 sums[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
  ADD_SQUARES(0, squares.x, coarseNumbers(&occlusion, square));
  ADD_SQUARES(squares.x, squares.y, blockNumbers(&occlusion, places[square]));
  ADD_SQUARES(squares.y, squares.z, quarterNumbers(&occlusion, places[square]));
  addOverLanes(sums, partials);

  if (LANE == 0) radiance[sample] = blendRadiance(&blend, sums, unshadowed, scales);
}
