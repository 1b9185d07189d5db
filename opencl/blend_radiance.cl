// The end of a triple product: radiance = scale * (unshadowed - sum) of every lobe, and their blend.
// Described in src/engine/shading_tables.h; the scalar twin is src/engine/reference/sample_shader.h.
// Sums are exact modulo 2^32, so lanes may add in any order.

// The receiver's normal as a blend of the tabulated lobes in `count` slots.
typedef struct {
  uint count;
  uint slots[3];
  float weights[3];
} Blend;

// One sum per channel and lobe.
#define LOBE_SUMS 9

inline Blend blendOf(LobeBlend receiver, uint count, __global const uint* lobeSlots) {
  const Blend blend = {count,
                       {lobeSlots[receiver.lobes.x], lobeSlots[receiver.lobes.y],
                        lobeSlots[receiver.lobes.z]},
                       {receiver.weights.x, receiver.weights.y, receiver.weights.z}};
  return blend;
}

#if LANES_PER_ITEM == 1
// Adds the sums of all lanes. `partials` is room for LOBE_SUMS sums of every lane.
inline void addOverLanes(uint4* sums, __local uint* partials) {
  for (uint i = 0; i < 3; ++i) {
    partials[(3 * i) * LANES + FIRST_LANE] = sums[i].x;
    partials[(3 * i + 1) * LANES + FIRST_LANE] = sums[i].y;
    partials[(3 * i + 2) * LANES + FIRST_LANE] = sums[i].z;
  }
  LANE_BARRIER();
  if (FIRST_LANE < LOBE_SUMS) {
    uint total = 0;
    for (uint lane = 0; lane < LANES; ++lane) total += partials[FIRST_LANE * LANES + lane];
    partials[FIRST_LANE * LANES] = total;
  }
  LANE_BARRIER();
  for (uint i = 0; i < 3; ++i)
    sums[i] = (uint4)(partials[(3 * i) * LANES], partials[(3 * i + 1) * LANES],
                      partials[(3 * i + 2) * LANES], 0);
}
#else
inline void addOverLanes(uint4* sums, __local uint* partials) {}
#endif

inline float4 lobeRadiance(uint slot, uint4 sum, __global const uint4* unshadowed,
                           __global const float4* scales) {
  return convert_float4(as_int4(unshadowed[slot] - sum)) * scales[slot];
}

inline float4 blendRadiance(const Blend* blend, const uint4* sums,
                            __global const uint4* unshadowed, __global const float4* scales) {
  float4 radiance =
      blend->weights[0] * lobeRadiance(blend->slots[0], sums[0], unshadowed, scales);
  for (uint i = 1; i < blend->count; ++i) {
    const float4 lobe = lobeRadiance(blend->slots[i], sums[i], unshadowed, scales);
    radiance = fma((float4)(blend->weights[i]), lobe, radiance);
  }
  return radiance;
}
