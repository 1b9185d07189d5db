// All steps of a sample in one kernel, from spheres to radiance; nothing but the radiance is written.
// The triple product is the sum of the weights of the blocked texels (src/engine/square_weights.h).

// The bit cubes of a tile: rows of a sample lie `rowStep` words apart, samples `sampleStep`; only
// of `occupied`, a word of row bits for every face, may hold blocked texels.
struct TileRows {
  const uint* rows;
  uint rowStep, sampleStep;
  const uint* occupied;
};

// The weights of the sample's blocked texels; a lane takes a column of every row.
__device__ inline uint4 addBlockedTexels(const TileRows* tile, const uint* weights) {
  uint4 sum = {0, 0, 0, 0};
  for (uint row = 0; row < BIT_CUBE_ROWS; ++row) {
    const uint bits = tile->rows[row];
    if (bits == 0) continue;
    const uint mask = 0u - (bits >> LANE & 1);
    const uint* own = weights + row * 3 * FACE_SIZE + LANE;
    sum.x += own[0] & mask;
    sum.y += own[FACE_SIZE] & mask;
    sum.z += own[2 * FACE_SIZE] & mask;
  }
  return sum;
}

__device__ inline void addLobe(const TileRows* tile, const uint* texelWeights, const Blend* blends,
                               uint lobe, uint4* sums) {
  if (blends->weights[lobe] != 0.0f)
    sums[lobe] = addBlockedTexels(tile, texelWeights + size_t(TEXEL_WEIGHTS) * blends->slots[lobe]);
}

// Rows of the tile, and room for the sums of addOverLanes().
#define SHADE_ROOM \
  (TILE * BIT_CUBE_ROWS > LOBE_SUMS * LANES ? TILE * BIT_CUBE_ROWS : LOBE_SUMS * LANES)

// What radiance takes from the host: the lobes' tables.
struct LobeTables {
  uint lobesPerReceiver;
  const uint* lobeSlots;
  const uint* texelWeights;
  const uint4* unshadowed;
  const float4* scales;
};

// Radiance of the samples of a tile from their blocked texels. `room` holds them and is room for the
// sums of lanes, too.
__device__ inline void shadeTile(const TileRows* tile, uint* room, const LobeBlend* receivers,
                                 const LobeTables* tables, float4* radiance) {
  const Blend blend =
      blendOf(receivers[FIRST_OF_TILE], tables->lobesPerReceiver, tables->lobeSlots);
  uint4 sums[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
  LANE_BARRIER();
  for (uint lobe = 0; lobe < blend.count; ++lobe)
    addLobe(tile, tables->texelWeights, &blend, lobe, sums);
  LANE_BARRIER();
  addOverLanes(sums, room);
  if (LANE == 0)
    radiance[FIRST_OF_TILE] = blendRadiance(&blend, sums, tables->unshadowed, tables->scales);
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
  uint occupied[FACES];
  mergeMasks(&tile, spheres, sphereCount, &table, mergeRoom, room, occupied);
  const TileRows rows = {room, 1, BIT_CUBE_ROWS, occupied};
  const LobeTables tables = {lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales};
  shadeTile(&rows, room, receivers, &tables, radiance);
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
  uint occupied[FACES];
  mergeCaps(&tile, spheres, sphereCount, caps, room, occupied);
  const TileRows rows = {room, TILE, 1, occupied};
  const LobeTables tables = {lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales};
  shadeTile(&rows, room, receivers, &tables, radiance);
}
