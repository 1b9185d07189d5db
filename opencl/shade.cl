// All steps of a sample in one kernel, from spheres to radiance; nothing but the radiance is written.
// The triple product is the sum of the weights of the blocked texels (src/engine/square_weights.h).

// The bit cubes of a tile: rows of a sample lie `rowStep` words apart, samples `sampleStep`; only those
// of `occupied`, a word of row bits for every face, may hold blocked texels.
typedef struct {
  __local const uint* rows;
  uint rowStep, sampleStep;
  const uint* occupied;
} TileRows;

#if LANES_PER_ITEM == 1
// The weights of the sample's blocked texels; a lane takes a column of every row.
inline uint4 addBlockedTexels(const TileRows* tile, __global const uint* weights) {
  uint4 sum = (uint4)(0);
  for (uint row = 0; row < BIT_CUBE_ROWS; ++row) {
    const uint bits = tile->rows[row];
    if (bits == 0) continue;
    const uint mask = -(bits >> FIRST_LANE & 1);
    __global const uint* own = weights + row * 3 * FACE_SIZE + FIRST_LANE;
    sum += (uint4)(own[0] & mask, own[FACE_SIZE] & mask, own[2 * FACE_SIZE] & mask, 0);
  }
  return sum;
}

inline void addLobe(const TileRows* tile, __global const uint* texelWeights, const Blend* blends,
                    uint lobe, uint4* sums) {
  if (blends->weights[lobe] != 0.0f)
    sums[lobe] = addBlockedTexels(tile, texelWeights + (size_t)TEXEL_WEIGHTS * blends->slots[lobe]);
}
#else
// Sums of the columns of a row: an element of a vector takes one column and the one 16 to its right.
typedef struct {
  uint16 red, green, blue;
} ColumnSums;

inline void addRow(ColumnSums* sums, uint bits, __global const uint16* weights) {
  const uint16 columns = (uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192,
                                  16384, 32768);
  const int16 left = ((uint16)(bits) & columns) != 0,
              right = ((uint16)(bits >> 16) & columns) != 0;
  sums->red = select(sums->red, sums->red + weights[0], left);
  sums->green = select(sums->green, sums->green + weights[2], left);
  sums->blue = select(sums->blue, sums->blue + weights[4], left);
  sums->red = select(sums->red, sums->red + weights[1], right);
  sums->green = select(sums->green, sums->green + weights[3], right);
  sums->blue = select(sums->blue, sums->blue + weights[5], right);
}

inline uint addElements(uint16 v) {
  return (((v.s0 + v.s1) + (v.s2 + v.s3)) + ((v.s4 + v.s5) + (v.s6 + v.s7))) +
         (((v.s8 + v.s9) + (v.sa + v.sb)) + ((v.sc + v.sd) + (v.se + v.sf)));
}

inline uint4 total(ColumnSums sums) {
  return (uint4)(addElements(sums.red), addElements(sums.green), addElements(sums.blue), 0);
}

#define NO_SUMS {(uint16)(0), (uint16)(0), (uint16)(0)}
#define FOR_EACH_ROW(row)                        \
  for (uint face = 0; face < FACES; ++face)      \
    FOR_EACH_BIT(rowOfFace, tile->occupied[face]) \
      for (uint row = face * FACE_SIZE + rowOfFace, once = 1; once; once = 0)

// The weights of a sample's blocked texels.
inline uint4 addBlockedTexels(const TileRows* tile, uint sample, __global const uint* weights) {
  __local const uint* rows = tile->rows + sample * tile->sampleStep;
  ColumnSums sums = NO_SUMS;
  FOR_EACH_ROW(row)
    addRow(&sums, rows[row * tile->rowStep], (__global const uint16*)weights + 6 * row);
  return total(sums);
}

// The same for two samples at once, so that weights are read once.
inline void addBlockedTexelsOfTwo(const TileRows* tile, uint sample, __global const uint* weights,
                                  uint4* one, uint4* other) {
  __local const uint* rows = tile->rows + sample * tile->sampleStep;
  __local const uint* otherRows = rows + tile->sampleStep;
  ColumnSums sums = NO_SUMS, otherSums = NO_SUMS;
  FOR_EACH_ROW(row) {
    __global const uint16* own = (__global const uint16*)weights + 6 * row;
    addRow(&sums, rows[row * tile->rowStep], own);
    addRow(&otherSums, otherRows[row * tile->rowStep], own);
  }
  *one = total(sums);
  *other = total(otherSums);
}

// One lobe's sums of two samples that follow each other.
inline void addLobeOfTwo(const TileRows* tile, uint sample, __global const uint* texelWeights,
                         const Blend* blends, uint lobe, uint4* sums, uint4* otherSums) {
  __global const uint* own = texelWeights + (size_t)TEXEL_WEIGHTS * blends[0].slots[lobe];
  __global const uint* other = texelWeights + (size_t)TEXEL_WEIGHTS * blends[1].slots[lobe];
  const bool isUsed = blends[0].weights[lobe] != 0.0f, otherIsUsed = blends[1].weights[lobe] != 0.0f;
  if (isUsed && otherIsUsed && own == other) {
    addBlockedTexelsOfTwo(tile, sample, own, sums + lobe, otherSums + lobe);
  } else {
    if (isUsed) sums[lobe] = addBlockedTexels(tile, sample, own);
    if (otherIsUsed) otherSums[lobe] = addBlockedTexels(tile, sample + 1, other);
  }
}
#endif

// Rows of the tile, and room for the sums of addOverLanes().
#define SHADE_ROOM \
  (TILE * BIT_CUBE_ROWS > LOBE_SUMS * LANES ? TILE * BIT_CUBE_ROWS : LOBE_SUMS * LANES)

// What radiance takes from the host: the lobes' tables.
typedef struct {
  uint lobesPerReceiver;
  __global const uint* lobeSlots;
  __global const uint* texelWeights;
  __global const uint4* unshadowed;
  __global const float4* scales;
} LobeTables;

// Radiance of the samples of a tile from their blocked texels. `room` holds them and is room for the
// sums of lanes, too.
#if LANES_PER_ITEM == 1
inline void shadeTile(const TileRows* tile, __local uint* room,
                      __global const LobeBlend* receivers, const LobeTables* tables,
                      __global float4* radiance) {
  const Blend blend =
      blendOf(receivers[FIRST_OF_TILE], tables->lobesPerReceiver, tables->lobeSlots);
  uint4 sums[3] = {(uint4)(0), (uint4)(0), (uint4)(0)};
  LANE_BARRIER();
  for (uint lobe = 0; lobe < blend.count; ++lobe)
    addLobe(tile, tables->texelWeights, &blend, lobe, sums);
  LANE_BARRIER();
  addOverLanes(sums, room);
  if (FIRST_LANE == 0)
    radiance[FIRST_OF_TILE] = blendRadiance(&blend, sums, tables->unshadowed, tables->scales);
}
#else
inline void shadeTile(const TileRows* tile, __local uint* room,
                      __global const LobeBlend* receivers, const LobeTables* tables,
                      __global float4* radiance) {
  for (size_t i = 0; i < TILE; i += 2) {
    __global const LobeBlend* own = receivers + FIRST_OF_TILE + i;
    const Blend blends[2] = {blendOf(own[0], tables->lobesPerReceiver, tables->lobeSlots),
                             blendOf(own[1], tables->lobesPerReceiver, tables->lobeSlots)};
    uint4 sums[3] = {(uint4)(0), (uint4)(0), (uint4)(0)};
    uint4 otherSums[3] = {(uint4)(0), (uint4)(0), (uint4)(0)};
    for (uint lobe = 0; lobe < tables->lobesPerReceiver; ++lobe)
      addLobeOfTwo(tile, i, tables->texelWeights, blends, lobe, sums, otherSums);
    radiance[FIRST_OF_TILE + i] =
        blendRadiance(&blends[0], sums, tables->unshadowed, tables->scales);
    radiance[FIRST_OF_TILE + i + 1] =
        blendRadiance(&blends[1], otherSums, tables->unshadowed, tables->scales);
  }
}
#endif

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
  uint occupied[FACES];
  mergeMasks(&tile, spheres, sphereCount, &table, mergeRoom, room, occupied);
  const TileRows rows = {room, 1, BIT_CUBE_ROWS, occupied};
  const LobeTables tables = {lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales};
  shadeTile(&rows, room, receivers, &tables, radiance);
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
  uint occupied[FACES];
  mergeCaps(&tile, spheres, sphereCount, caps, room, occupied);
  const TileRows rows = {room, TILE, 1, occupied};
  const LobeTables tables = {lobesPerReceiver, lobeSlots, texelWeights, unshadowed, scales};
  shadeTile(&rows, room, receivers, &tables, radiance);
}
