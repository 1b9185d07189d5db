// All steps of a sample in one kernel, from spheres to radiance; nothing but the radiance is written.
// The triple product is the sum of the weights of the blocked texels (src/engine/square_weights.h).

// Adds the weights of a sample's blocked texels; its rows lie `step` words apart, and only `groups`
// of them hold any.
// A lane takes a column of every row.
__device__ inline uint4 addBlockedTexels(const uint* rows, uint step, uint,
                              const uint* weights) {
  uint4 sum = {0, 0, 0, 0};
  for (uint row = 0; row < BIT_CUBE_ROWS; ++row) {
    const uint bits = rows[row * step];
    if (bits == 0) continue;
    const uint mask = 0u - (bits >> LANE & 1);
    const uint* own = weights + row * 3 * FACE_SIZE + LANE;
    sum.x += own[0] & mask;
    sum.y += own[FACE_SIZE] & mask;
    sum.z += own[2 * FACE_SIZE] & mask;
  }
  return sum;
}

// Rows of the tile, and room for the sums of addOverLanes().
#define SHADE_ROOM \
  (TILE * BIT_CUBE_ROWS > LOBE_SUMS * LANES ? TILE * BIT_CUBE_ROWS : LOBE_SUMS * LANES)

// Radiance of the samples of a tile from their blocked texels in `room`, which is room for the sums of
// lanes, too.
__device__ inline void shadeRows(uint* room, uint sampleStep, uint rowStep, uint groups, const LobeBlend* receivers,
                      uint lobesPerReceiver, const uint* lobeSlots,
                      const uint* texelWeights, const uint4* unshadowed,
                      const float4* scales, float4* radiance) {
  LANE_BARRIER();
  for (size_t i = 0; i < TILE; ++i) {
    const Blend blend = blendOf(receivers[FIRST_OF_TILE + i], lobesPerReceiver, lobeSlots);
    uint4 sums[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
    for (uint lobe = 0; lobe < blend.count; ++lobe)
      if (blend.weights[lobe] != 0.0f)
        sums[lobe] = addBlockedTexels(room + i * sampleStep, rowStep, groups,
                                      texelWeights + size_t(TEXEL_WEIGHTS) * blend.slots[lobe]);
    LANE_BARRIER();
    addOverLanes(sums, room);
    if (LANE == 0)
      radiance[FIRST_OF_TILE + i] = blendRadiance(&blend, sums, unshadowed, scales);
  }
}

HAARLIGHT_KERNEL void shadeByTable(const float4* __restrict__ positions,
                                   const float4* __restrict__ normals,
                                   const LobeBlend* __restrict__ receivers,
                                   const float* __restrict__ spheres,
                                   const uint sphereCount,
                                   const uint* __restrict__ tableEntries,
                                   const uint* __restrict__ tableGroups,
                                   const uint lobesPerReceiver,
                                   const uint* __restrict__ lobeSlots,
                                   const uint* __restrict__ texelWeights,
                                   const uint4* __restrict__ unshadowed,
                                   const float4* __restrict__ scales,
                                   float4* __restrict__ radiance) {
  SAMPLE_LOCAL(uint, mergeRoom, MERGE_ROOM);
  SAMPLE_LOCAL(uint, room, SHADE_ROOM);
  const Tile tile = loadTile(positions, normals);
  const SphereTable table = {tableEntries, tableGroups};
  const uint groups = mergeMasks(&tile, spheres, sphereCount, &table, mergeRoom, room);
  shadeRows(room, BIT_CUBE_ROWS, 1, groups, receivers, lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales,
            radiance);
}

HAARLIGHT_KERNEL void shadeExactly(const float4* __restrict__ positions,
                                   const float4* __restrict__ normals,
                                   const LobeBlend* __restrict__ receivers,
                                   const float* __restrict__ spheres,
                                   const uint sphereCount,
                                   const uint lobesPerReceiver,
                                   const uint* __restrict__ lobeSlots,
                                   const uint* __restrict__ texelWeights,
                                   const uint4* __restrict__ unshadowed,
                                   const float4* __restrict__ scales,
                                   float4* __restrict__ radiance) {
  SAMPLE_LOCAL(float, caps, CAP_FLOATS);
  SAMPLE_LOCAL(uint, room, SHADE_ROOM);
  const Tile tile = loadTile(positions, normals);
  const uint groups = mergeCaps(&tile, spheres, sphereCount, caps, room);
  shadeRows(room, 1, TILE, groups, receivers, lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales,
            radiance);
}
