// The tree at the end of a canonical sum (src/base/canonical_order.h): lanes add their partial sums
// as halves 16, 8, 4, 2, 1. All lanes of a block have to come by.

__device__ inline float addPartials(float* partials) {
  for (uint width = LANES / 2; width > 0; width /= 2) {
    if (LANE < width) partials[LANE] += partials[LANE + width];
    LANE_BARRIER();
  }
  return partials[0];
}

__device__ inline float largestPartial(float* partials) {
  for (uint width = LANES / 2; width > 0; width /= 2) {
    if (LANE < width) partials[LANE] = fmaxf(partials[LANE], partials[LANE + width]);
    LANE_BARRIER();
  }
  return partials[0];
}
