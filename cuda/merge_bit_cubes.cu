// Step 1: the union of all spheres' visibility cubes, per sample.
//
// A table entry is the number of its first group of 16 rows << 12 and which groups it has
// (src/visibility/sphere_table.h); group 0 of the data is empty.

#define GROUPS_OF(entry) ((entry) & ALL_GROUPS)

// The table on the device.
struct SphereTable {
  const uint* entries;
  const uint* groups;
};

// Number of set bits among 12, by adding neighbours.
__device__ inline uint groupCount(uint mask) {
  uint count = mask - (mask >> 1 & 0x555u);
  count = (count & 0x333u) + (count >> 2 & 0x333u);
  return (count + (count >> 4) + (count >> 8)) & 0xfu;
}

#define MERGE_ROOM LANES

// A lane takes row lane % 16 of every other group. None touches another's rows, so masks need no
// barrier between them.
__device__ inline void addMask(uint* rows, uint entry, const uint* groups) {
  const uint occupied = GROUPS_OF(entry);
  const uint* own = groups + size_t(GROUP_ROWS) * (entry >> GROUPS) + LANE % GROUP_ROWS;
  for (uint face = 0; face < FACES; ++face) {
    const uint group = 2 * face + LANE / GROUP_ROWS;
    if (occupied >> group & 1)
      rows[face * FACE_SIZE + LANE] |= own[GROUP_ROWS * groupCount(occupied & ((1u << group) - 1))];
  }
}

// Spheres are taken 32 at a time: each lane finds the table entry of one of them, then all lanes read
// the rows of all 32.
__device__ inline void mergeMasks(const Tile* tile, const float* spheres, uint sphereCount,
                                  const SphereTable* table, uint* room, uint* rows,
                       uint* occupied) {
  const uint stride = sphereStride(sphereCount);
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += LANES) {
    room[LANE] = table->entries[tableEntry(seeSpheres(tile, spheres, stride, first))];
    LANE_BARRIER();
    const uint count = min(uint(LANES), sphereCount - first);
    for (uint i = 0; i < count; ++i) addMask(rows, room[i], table->groups);
    LANE_BARRIER();
  }
  occupyAllRows(occupied);
}

HAARLIGHT_KERNEL void mergeBitCubes(const float4* __restrict__ positions,
                                    const float4* __restrict__ normals,
                                    const float* __restrict__ spheres,
                                    const uint sphereCount,
                                    const uint* __restrict__ tableEntries,
                                    const uint* __restrict__ tableGroups,
                                    uint* __restrict__ bitCubes) {
  SAMPLE_LOCAL(uint, room, MERGE_ROOM);
  SAMPLE_LOCAL(uint, rows, TILE * BIT_CUBE_ROWS);
  const Tile tile = loadTile(positions, normals);
  const SphereTable table = {tableEntries, tableGroups};
  uint occupied[FACES];
  mergeMasks(&tile, spheres, sphereCount, &table, room, rows, occupied);
  storeRows(rows, bitCubes + FIRST_OF_TILE * BIT_CUBE_ROWS);
}
