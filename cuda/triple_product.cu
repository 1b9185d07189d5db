// Step 3: radiance = unshadowed radiance - triple product of light, occlusion and lobe.
//
// The tables and the order of summation are described in src/engine/shading_tables.h; the scalar
// twin is src/engine/reference/reference_engine.cpp. Lane j owns partial sum j; lists are padded
// to multiples of 32 with zero terms.

// A sample's occlusion in the Haar basis.
struct Occlusion {
  const float* coefficients;
  const float* means;
  const ushort* blocks;
  const float* blockTable;
  uint levels;
};

// The receiver's normal as a blend of the tabulated lobes in `count` slots.
struct Blend {
  uint count;
  uint slots[3];
  float weights[3];
};

// Occlusion on one square: horizontal, vertical, diagonal coefficient and mean.
__device__ inline float4 coarseValues(const Occlusion* occlusion, uint place) {
  const float* first = occlusion->coefficients + (place & 0xffff);
  return make_float4(first[0], first[1], first[2], occlusion->means[place >> 16]);
}

__device__ inline float4 blockValues(const Occlusion* occlusion, uint place) {
  const float* entry =
      occlusion->blockTable + uint(occlusion->blocks[place]) * BLOCK_TABLE_STRIDE;
  if (occlusion->levels == 1) return make_float4(0.0f, 0.0f, 0.0f, entry[0]);
  return make_float4(entry[1], entry[2], entry[3], entry[0]);
}

__device__ inline float4 quarterValues(const Occlusion* occlusion, uint place) {
  const float* entry =
      occlusion->blockTable + uint(occlusion->blocks[place / 4]) * BLOCK_TABLE_STRIDE;
  if (occlusion->levels == 1) return make_float4(0.0f, 0.0f, 0.0f, entry[0]);
  const uint quarter = place % 4;
  const float* fine = entry + 4 + 3 * quarter;
  const float x = (quarter & 1) ? -1.0f : 1.0f, y = (quarter & 2) ? -1.0f : 1.0f;
  const float mean = entry[0] + 8.0f * ((x * entry[1] + y * entry[2]) + x * y * entry[3]);
  return make_float4(fine[0], fine[1], fine[2], mean);
}

__device__ inline float4 multiplyAdd(float factor, float4 value, float4 sum) {
  return make_float4(__fmaf_rn(factor, value.x, sum.x), __fmaf_rn(factor, value.y, sum.y),
                     __fmaf_rn(factor, value.z, sum.z), __fmaf_rn(factor, value.w, sum.w));
}

__device__ inline float4 blendRows(const Blend* blend, const float4* rows, uint stride, uint term) {
  const float4 row = rows[blend->slots[0] * stride + term];
  const float weight = blend->weights[0];
  float4 sum = make_float4(weight * row.x, weight * row.y, weight * row.z, weight * row.w);
  for (uint i = 1; i < blend->count; ++i)
    sum = multiplyAdd(blend->weights[i], rows[blend->slots[i] * stride + term], sum);
  return sum;
}

__device__ inline float dotValues(float4 weight, float4 values) {
  float sum = weight.x * values.x;
  sum = __fmaf_rn(weight.y, values.y, sum);
  sum = __fmaf_rn(weight.z, values.z, sum);
  return __fmaf_rn(weight.w, values.w, sum);
}

#define ADD_TERM(coefficient, value)           \
  {                                            \
    const float4 factor = (coefficient);       \
    const float term = (value);                \
    red = __fmaf_rn(factor.x, term, red);      \
    green = __fmaf_rn(factor.y, term, green);  \
    blue = __fmaf_rn(factor.z, term, blue);    \
  }

#define ADD_LIGHT_TERMS(begin, end, valuesAt)                                              \
  for (uint place = (begin) + LANE; place < (end); place += LANES) {                       \
    const float4 weight = blendRows(&blend, lightWeights, lightTermCount, place);          \
    const float4 values = valuesAt(&occlusion, lightPlaces[place]);                        \
    ADD_TERM(lightCoefficients[place], dotValues(weight, values));                         \
  }

#define ADD_LOBE_TERMS(list, occlusionAt)                                                  \
  for (uint k = lobeListStarts[list] + LANE; k < lobeListStarts[(list) + 1]; k += LANES) { \
    const uint place = lobePlaces[k];                                                      \
    const float lobe = blend.weights[i] * lobeValues[k];                                   \
    ADD_TERM(lightMeans[place >> 16], lobe * (occlusionAt(place & 0xffff)));               \
  }

#define COARSE_OCCLUSION(place) occlusion.coefficients[place]
#define BLOCK_OCCLUSION(place)                                                          \
  occlusion.blockTable[uint(occlusion.blocks[(place) / BLOCK_TABLE_STRIDE]) *           \
                           BLOCK_TABLE_STRIDE +                                         \
                       (place) % BLOCK_TABLE_STRIDE]

HAARLIGHT_KERNEL void tripleProduct(const float* __restrict__ coefficients,
                                    const float* __restrict__ means,
                                    const ushort* __restrict__ blocks,
                                    const float* __restrict__ blockTable,
                                    const LobeBlend* __restrict__ receivers,
                                    const uint lobesPerReceiver, const uint levels,
                                    const uint* __restrict__ lobeSlots,
                                    const uint4 lightListEnds,
                                    const uint* __restrict__ lightPlaces,
                                    const float4* __restrict__ lightCoefficients,
                                    const float4* __restrict__ lightWeights,
                                    const uint* __restrict__ lobeListStarts,
                                    const uint* __restrict__ lobePlaces,
                                    const float* __restrict__ lobeValues,
                                    const float4* __restrict__ lightMeans,
                                    const float4* __restrict__ unshadowed,
                                    float4* __restrict__ radiance) {
  SAMPLE_LOCAL(float, redPartials, LANES);
  SAMPLE_LOCAL(float, greenPartials, LANES);
  SAMPLE_LOCAL(float, bluePartials, LANES);
  const size_t sample = SAMPLE;
  const Occlusion occlusion = {coefficients + sample * FACES * COARSE_COEFFICIENTS,
                               means + sample * FACES * COARSE_MEANS, blocks + sample * BLOCKS,
                               blockTable, levels};
  const LobeBlend receiver = receivers[sample];
  const Blend blend = {lobesPerReceiver,
                       {lobeSlots[receiver.lobes.x], lobeSlots[receiver.lobes.y],
                        lobeSlots[receiver.lobes.z]},
                       {receiver.weights.x, receiver.weights.y, receiver.weights.z}};
  const uint lightTermCount = lightListEnds.z;

  float red = 0.0f, green = 0.0f, blue = 0.0f;

  ADD_LIGHT_TERMS(0, lightListEnds.x, coarseValues);
  ADD_LIGHT_TERMS(lightListEnds.x, lightListEnds.y, blockValues);
  ADD_LIGHT_TERMS(lightListEnds.y, lightListEnds.z, quarterValues);
  for (uint i = 0; i < blend.count; ++i) {
    const uint list = blend.slots[i] * TERM_DETAILS;
    ADD_LOBE_TERMS(list, COARSE_OCCLUSION);
    if (levels == 1) continue;
    ADD_LOBE_TERMS(list + 1, BLOCK_OCCLUSION);
    ADD_LOBE_TERMS(list + 2, BLOCK_OCCLUSION);
  }

  redPartials[LANE] = red;
  greenPartials[LANE] = green;
  bluePartials[LANE] = blue;
  LANE_BARRIER();
  const float redSum = addPartials(redPartials), greenSum = addPartials(greenPartials),
              blueSum = addPartials(bluePartials);
  const float4 open = blendRows(&blend, unshadowed, 1, 0);
  if (LANE == 0)
    radiance[sample] =
        make_float4(open.x - redSum, open.y - greenSum, open.z - blueSum, 0.0f);
}
