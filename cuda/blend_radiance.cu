// The end of a triple product: radiance = scale * (unshadowed - sum) of every lobe, and their blend.
// Described in src/engine/shading_tables.h; the scalar twin is src/engine/reference/sample_shader.h.
// Sums are exact modulo 2^32, so lanes may add in any order.

// The receiver's normal as a blend of the tabulated lobes in `count` slots.
struct Blend {
  uint count;
  uint slots[3];
  float weights[3];
};

// One sum per channel and lobe.
#define LOBE_SUMS 9

__device__ inline Blend blendOf(LobeBlend receiver, uint count, const uint* lobeSlots) {
  const Blend blend = {count,
                       {lobeSlots[receiver.lobes.x], lobeSlots[receiver.lobes.y],
                        lobeSlots[receiver.lobes.z]},
                       {receiver.weights.x, receiver.weights.y, receiver.weights.z}};
  return blend;
}

// Adds the sums of all lanes. `partials` is room for LOBE_SUMS sums of every lane.
__device__ inline void addOverLanes(uint4* sums, uint* partials) {
  for (uint i = 0; i < 3; ++i) {
    partials[(3 * i) * LANES + LANE] = sums[i].x;
    partials[(3 * i + 1) * LANES + LANE] = sums[i].y;
    partials[(3 * i + 2) * LANES + LANE] = sums[i].z;
  }
  LANE_BARRIER();
  if (LANE < LOBE_SUMS) {
    uint total = 0;
    for (uint lane = 0; lane < LANES; ++lane) total += partials[LANE * LANES + lane];
    partials[LANE * LANES] = total;
  }
  LANE_BARRIER();
  for (uint i = 0; i < 3; ++i)
    sums[i] = make_uint4(partials[(3 * i) * LANES], partials[(3 * i + 1) * LANES],
                         partials[(3 * i + 2) * LANES], 0);
}

__device__ inline float4 lobeRadiance(uint slot, uint4 sum, const uint4* unshadowed,
                                      const float4* scales) {
  const uint4 open = unshadowed[slot];
  const float4 scale = scales[slot];
  return make_float4(float(int(open.x - sum.x)) * scale.x,
                     float(int(open.y - sum.y)) * scale.y,
                     float(int(open.z - sum.z)) * scale.z, 0.0f);
}

__device__ inline float4 blendRadiance(const Blend* blend, const uint4* sums,
                                       const uint4* unshadowed, const float4* scales) {
  const float4 first = lobeRadiance(blend->slots[0], sums[0], unshadowed, scales);
  const float weight = blend->weights[0];
  float4 radiance = make_float4(weight * first.x, weight * first.y, weight * first.z, 0.0f);
  for (uint i = 1; i < blend->count; ++i) {
    const float4 lobe = lobeRadiance(blend->slots[i], sums[i], unshadowed, scales);
    radiance.x = __fmaf_rn(blend->weights[i], lobe.x, radiance.x);
    radiance.y = __fmaf_rn(blend->weights[i], lobe.y, radiance.y);
    radiance.z = __fmaf_rn(blend->weights[i], lobe.z, radiance.z);
  }
  return radiance;
}
