// All steps of a sample in one kernel, from spheres to radiance; nothing but the radiance is written.
// The triple product is the sum of the weights of the blocked texels (src/engine/square_weights.h).

// Adds the weights of a sample's blocked texels; its rows lie `step` words apart, and only `groups`
// of them hold any.
#if LANES_PER_ITEM == 1
// A lane takes a column of every row.
inline uint4 addBlockedTexels(__local const uint* rows, uint step, uint groups,
                              __global const uint* weights) {
  uint4 sum = (uint4)(0);
  for (uint row = 0; row < BIT_CUBE_ROWS; ++row) {
    const uint bits = rows[row * step];
    if (bits == 0) continue;
    const uint mask = -(bits >> FIRST_LANE & 1);
    __global const uint* own = weights + row * 3 * FACE_SIZE + FIRST_LANE;
    sum += (uint4)(own[0] & mask, own[FACE_SIZE] & mask, own[2 * FACE_SIZE] & mask, 0);
  }
  return sum;
}
#else
inline uint addElements(uint16 v) {
  return (((v.s0 + v.s1) + (v.s2 + v.s3)) + ((v.s4 + v.s5) + (v.s6 + v.s7))) +
         (((v.s8 + v.s9) + (v.sa + v.sb)) + ((v.sc + v.sd) + (v.se + v.sf)));
}

// An element of a vector takes a column of every row, and the one 16 columns to its right.
inline uint4 addBlockedTexels(__local const uint* rows, uint step, uint groups,
                              __global const uint* weights) {
  const uint16 columns = (uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192,
                                  16384, 32768);
  uint16 red = 0, green = 0, blue = 0;
  for (; groups; groups &= groups - 1) {
    const uint first = GROUP_ROWS * (31 - clz(groups & -groups));
    for (uint row = first; row < first + GROUP_ROWS; ++row) {
      __global const uint16* own = (__global const uint16*)(weights + row * 3 * FACE_SIZE);
      const uint bits = rows[row * step];
      const int16 left = ((uint16)(bits) & columns) != 0,
                  right = ((uint16)(bits >> 16) & columns) != 0;
      red = select(red, red + own[0], left);
      green = select(green, green + own[2], left);
      blue = select(blue, blue + own[4], left);
      red = select(red, red + own[1], right);
      green = select(green, green + own[3], right);
      blue = select(blue, blue + own[5], right);
    }
  }
  return (uint4)(addElements(red), addElements(green), addElements(blue), 0);
}
#endif

// Rows of the tile, and room for the sums of addOverLanes().
#define SHADE_ROOM \
  (TILE * BIT_CUBE_ROWS > LOBE_SUMS * LANES ? TILE * BIT_CUBE_ROWS : LOBE_SUMS * LANES)

// Radiance of the samples of a tile from their blocked texels in `room`, which is room for the sums of
// lanes, too.
inline void shadeRows(__local uint* room, uint sampleStep, uint rowStep, uint groups, __global const LobeBlend* receivers,
                      uint lobesPerReceiver, __global const uint* lobeSlots,
                      __global const uint* texelWeights, __global const uint4* unshadowed,
                      __global const float4* scales, __global float4* radiance) {
  LANE_BARRIER();
  for (size_t i = 0; i < TILE; ++i) {
    const Blend blend = blendOf(receivers[FIRST_OF_TILE + i], lobesPerReceiver, lobeSlots);
    uint4 sums[3] = {(uint4)(0), (uint4)(0), (uint4)(0)};
    for (uint lobe = 0; lobe < blend.count; ++lobe)
      if (blend.weights[lobe] != 0.0f)
        sums[lobe] = addBlockedTexels(room + i * sampleStep, rowStep, groups,
                                      texelWeights + (size_t)TEXEL_WEIGHTS * blend.slots[lobe]);
    LANE_BARRIER();
    addOverLanes(sums, room);
    if (FIRST_LANE == 0)
      radiance[FIRST_OF_TILE + i] = blendRadiance(&blend, sums, unshadowed, scales);
  }
}

HAARLIGHT_KERNEL void shadeByTable(__global const float4* restrict positions,
                                   __global const float4* restrict normals,
                                   __global const LobeBlend* restrict receivers,
                                   __global const float* restrict spheres,
                                   const uint sphereCount,
                                   __global const uint* restrict tableEntries,
                                   __global const uint* restrict tableGroups,
                                   const uint lobesPerReceiver,
                                   __global const uint* restrict lobeSlots,
                                   __global const uint* restrict texelWeights,
                                   __global const uint4* restrict unshadowed,
                                   __global const float4* restrict scales,
                                   __global float4* restrict radiance) {
  SAMPLE_LOCAL(uint, mergeRoom, MERGE_ROOM);
  SAMPLE_LOCAL(uint, room, SHADE_ROOM);
  const Tile tile = loadTile(positions, normals);
  const SphereTable table = {tableEntries, tableGroups};
  const uint groups = mergeMasks(&tile, spheres, sphereCount, &table, mergeRoom, room);
  shadeRows(room, BIT_CUBE_ROWS, 1, groups, receivers, lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales,
            radiance);
}

HAARLIGHT_KERNEL void shadeExactly(__global const float4* restrict positions,
                                   __global const float4* restrict normals,
                                   __global const LobeBlend* restrict receivers,
                                   __global const float* restrict spheres,
                                   const uint sphereCount,
                                   const uint lobesPerReceiver,
                                   __global const uint* restrict lobeSlots,
                                   __global const uint* restrict texelWeights,
                                   __global const uint4* restrict unshadowed,
                                   __global const float4* restrict scales,
                                   __global float4* restrict radiance) {
  SAMPLE_LOCAL(float, caps, CAP_FLOATS);
  SAMPLE_LOCAL(uint, room, SHADE_ROOM);
  const Tile tile = loadTile(positions, normals);
  const uint groups = mergeCaps(&tile, spheres, sphereCount, caps, room);
  shadeRows(room, 1, TILE, groups, receivers, lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales,
            radiance);
}
