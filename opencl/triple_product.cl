// Step 3: radiance = unshadowed radiance - triple product of light, occlusion and lobe.
//
// The tables and the order of summation are described in src/engine/shading_tables.h; the scalar
// twin is src/engine/reference/reference_engine.cpp. Lane j owns partial sum j; lists are padded
// to multiples of 32 with zero terms.

// A sample's occlusion in the Haar basis.
typedef struct {
  __global const float* coefficients;
  __global const float* means;
  __global const ushort* blocks;
  __global const float* blockTable;
  uint levels;
} Occlusion;

// The receiver's normal as a blend of the tabulated lobes in `count` slots.
typedef struct {
  uint count;
  uint slots[3];
  float weights[3];
} Blend;

// Occlusion on one square: horizontal, vertical, diagonal coefficient and mean.
inline float4 coarseValues(const Occlusion* occlusion, uint place) {
  __global const float* first = occlusion->coefficients + (place & 0xffff);
  return (float4)(first[0], first[1], first[2], occlusion->means[place >> 16]);
}

inline float4 blockValues(const Occlusion* occlusion, uint place) {
  __global const float* entry =
      occlusion->blockTable + (uint)occlusion->blocks[place] * BLOCK_TABLE_STRIDE;
  if (occlusion->levels == 1) return (float4)(0.0f, 0.0f, 0.0f, entry[0]);
  return vload4(0, entry).yzwx;
}

inline float4 quarterValues(const Occlusion* occlusion, uint place) {
  __global const float* entry =
      occlusion->blockTable + (uint)occlusion->blocks[place / 4] * BLOCK_TABLE_STRIDE;
  if (occlusion->levels == 1) return (float4)(0.0f, 0.0f, 0.0f, entry[0]);
  const uint quarter = place % 4;
  __global const float* fine = entry + 4 + 3 * quarter;
  const float x = (quarter & 1) ? -1.0f : 1.0f, y = (quarter & 2) ? -1.0f : 1.0f;
  const float mean = entry[0] + 8.0f * ((x * entry[1] + y * entry[2]) + x * y * entry[3]);
  return (float4)(fine[0], fine[1], fine[2], mean);
}

inline float4 multiplyAdd(float factor, float4 value, float4 sum) {
  return (float4)(fma(factor, value.x, sum.x), fma(factor, value.y, sum.y),
                  fma(factor, value.z, sum.z), fma(factor, value.w, sum.w));
}

inline float4 blendRows(const Blend* blend, __global const float4* rows, uint stride, uint term) {
  float4 sum = blend->weights[0] * rows[blend->slots[0] * stride + term];
  for (uint i = 1; i < blend->count; ++i)
    sum = multiplyAdd(blend->weights[i], rows[blend->slots[i] * stride + term], sum);
  return sum;
}

inline float dotValues(float4 weight, float4 values) {
  float sum = weight.x * values.x;
  sum = fma(weight.y, values.y, sum);
  sum = fma(weight.z, values.z, sum);
  return fma(weight.w, values.w, sum);
}

#define ADD_TERM(lane, coefficient, value) \
  OF_LANE(sums, lane) = fma(coefficient, (float4)(value), OF_LANE(sums, lane));

#define ADD_LIGHT_TERMS(begin, end, valuesAt)                                              \
  for (uint first = (begin); first < (end); first += LANES)                                \
    FOR_EACH_LANE(lane) {                                                                  \
      const float4 weight = blendRows(&blend, lightWeights, lightTermCount, first + lane); \
      const float4 values = valuesAt(&occlusion, lightPlaces[first + lane]);               \
      ADD_TERM(lane, lightCoefficients[first + lane], dotValues(weight, values));          \
    }

#define ADD_LOBE_TERMS(list, occlusionAt)                                                     \
  for (uint first = lobeListStarts[list]; first < lobeListStarts[(list) + 1]; first += LANES) \
    FOR_EACH_LANE(lane) {                                                                     \
      const uint place = lobePlaces[first + lane];                                            \
      const float lobe = blend.weights[i] * lobeValues[first + lane];                         \
      ADD_TERM(lane, lightMeans[place >> 16], lobe * (occlusionAt(place & 0xffff)));          \
    }

#define COARSE_OCCLUSION(place) occlusion.coefficients[place]
#define BLOCK_OCCLUSION(place)                                                          \
  occlusion.blockTable[(uint)occlusion.blocks[(place) / BLOCK_TABLE_STRIDE] *           \
                           BLOCK_TABLE_STRIDE +                                         \
                       (place) % BLOCK_TABLE_STRIDE]

HAARLIGHT_KERNEL void tripleProduct(__global const float* restrict coefficients,
                                    __global const float* restrict means,
                                    __global const ushort* restrict blocks,
                                    __global const float* restrict blockTable,
                                    __global const LobeBlend* restrict receivers,
                                    const uint lobesPerReceiver, const uint levels,
                                    __global const uint* restrict lobeSlots,
                                    const uint4 lightListEnds,
                                    __global const uint* restrict lightPlaces,
                                    __global const float4* restrict lightCoefficients,
                                    __global const float4* restrict lightWeights,
                                    __global const uint* restrict lobeListStarts,
                                    __global const uint* restrict lobePlaces,
                                    __global const float* restrict lobeValues,
                                    __global const float4* restrict lightMeans,
                                    __global const float4* restrict unshadowed,
                                    __global float4* restrict radiance) {
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

  float4 sums[LANES_PER_ITEM];
  FOR_EACH_LANE(lane) OF_LANE(sums, lane) = (float4)(0.0f);

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

  FOR_EACH_LANE(lane) {
    redPartials[lane] = OF_LANE(sums, lane).x;
    greenPartials[lane] = OF_LANE(sums, lane).y;
    bluePartials[lane] = OF_LANE(sums, lane).z;
  }
  LANE_BARRIER();
  const float redSum = addPartials(redPartials), greenSum = addPartials(greenPartials),
              blueSum = addPartials(bluePartials);
  const float4 open = blendRows(&blend, unshadowed, 1, 0);
  if (FIRST_LANE == 0)
    radiance[sample] = (float4)(open.x - redSum, open.y - greenSum, open.z - blueSum, 0.0f);
}
