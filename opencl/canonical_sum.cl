// The tree at the end of a canonical sum (src/base/canonical_order.h): lanes add their partial sums
// as halves 16, 8, 4, 2, 1. All lanes of a group have to come by.

inline float addPartials(__local float* partials) {
  for (uint width = LANES / 2; width > 0; width /= 2) {
    FOR_EACH_LANE(lane) if (lane < width) partials[lane] += partials[lane + width];
    LANE_BARRIER();
  }
  return partials[0];
}

inline float largestPartial(__local float* partials) {
  for (uint width = LANES / 2; width > 0; width /= 2) {
    FOR_EACH_LANE(lane) if (lane < width)
      partials[lane] = fmax(partials[lane], partials[lane + width]);
    LANE_BARRIER();
  }
  return partials[0];
}
