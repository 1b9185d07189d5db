// Step 1: the union of all spheres' visibility cubes, per sample.
//
// A table entry is the number of its first group of 16 rows << 12 and which groups it has
// (src/visibility/sphere_table.h); group 0 of the data is empty.

#define GROUPS_OF(entry) ((entry) & ALL_GROUPS)

// The table on the device.
typedef struct {
  __global const uint* entries;
  __global const uint* groups;
} SphereTable;

// Number of set bits among 12, by adding neighbours.
inline LaneUint groupCount(LaneUint mask) {
  LaneUint count = mask - (mask >> 1 & 0x555u);
  count = (count & 0x333u) + (count >> 2 & 0x333u);
  return (count + (count >> 4) + (count >> 8)) & 0xfu;
}

#if LANES_PER_ITEM == 1
#define MERGE_ROOM LANES

// A lane takes row lane % 16 of every other group. None touches another's rows, so masks need no
// barrier between them.
inline void addMask(__local uint* rows, uint entry, __global const uint* groups) {
  const uint occupied = GROUPS_OF(entry);
  __global const uint* own =
      groups + (size_t)GROUP_ROWS * (entry >> GROUPS) + FIRST_LANE % GROUP_ROWS;
  for (uint face = 0; face < FACES; ++face) {
    const uint group = 2 * face + FIRST_LANE / GROUP_ROWS;
    if (occupied >> group & 1)
      rows[face * FACE_SIZE + FIRST_LANE] |=
          own[GROUP_ROWS * groupCount(occupied & ((1u << group) - 1))];
  }
}

// Spheres are taken 32 at a time: each lane finds the table entry of one of them, then all lanes read
// the rows of all 32.
inline void mergeMasks(const Tile* tile, __global const float* spheres, uint sphereCount,
                       const SphereTable* table, __local uint* room, __local uint* rows,
                       uint* occupied) {
  const uint stride = sphereStride(sphereCount);
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += LANES) {
    room[FIRST_LANE] = table->entries[tableEntry(seeSpheres(tile, spheres, stride, first))];
    LANE_BARRIER();
    const uint count = min((uint)LANES, sphereCount - first);
    for (uint i = 0; i < count; ++i) addMask(rows, room[i], table->groups);
    LANE_BARRIER();
  }
  occupyAllRows(occupied);
}
#else
// Spheres are taken 16 at a time: entries of them all for all samples, then lists of the groups that
// any sample needs, then group by group and sample by sample the union over a list. So a group of a
// sample's rows is loaded and stored once, and nothing waits for what was stored just before.
#define LIST_SIZE (SPHERES_AT_ONCE * TILE)
#define MERGE_ROOM ((1 + GROUPS) * LIST_SIZE)

inline void findTableEntries(const Tile* tile, __global const float* spheres, uint stride,
                             uint first, uint count, __global const uint* table,
                             __local uint* entries) {
  for (uint i = 0; i < count; ++i)
    ((__local uint16*)entries)[i] = tableEntry(seeSphere(tile, spheres, stride, first + i));
  for (uint i = 0; i < count * TILE; ++i) entries[i] = table[entries[i]];
}

// Which group of the data every sample needs, sphere by sphere: group * 256 + sphere * 16 + sample,
// the empty group where it needs none. Returns the groups that have a list.
inline uint listGroups(__local const uint* entries, uint count, __local uint* lists, uint* sizes) {
  uint occupied = 0;
  for (uint group = 0; group < GROUPS; ++group) sizes[group] = 0;
  for (uint i = 0; i < count; ++i) {
    const uint16 entry = ((__local const uint16*)entries)[i], own = GROUPS_OF(entry);
    const uint groups = joinElements(own);
    occupied |= groups;
    FOR_EACH_BIT(group, groups) {
      const uint bit = 1u << group;
      const uint16 place = (entry >> GROUPS) + groupCount(own & (bit - 1));
      ((__local uint16*)(lists + group * LIST_SIZE))[sizes[group]++] =
          select((uint16)(0), place, (int16)((own & bit) != 0));
    }
  }
  return occupied;
}

inline void addList(__local uint16* rows, __local const uint* list, uint size,
                    __global const uint16* groups) {
  for (uint sample = 0; sample < TILE; ++sample) {
    uint16 joined = rows[sample * GROUPS];
    for (uint i = 0; i < size; ++i) joined |= groups[list[i * TILE + sample]];
    rows[sample * GROUPS] = joined;
  }
}

// Of some groups, the rows that hold a bit of any sample.
inline void occupyRows(__local const uint16* rows, uint groups, uint* occupied) {
  const uint16 rowBits = (uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192,
                                  16384, 32768);
  for (uint face = 0; face < FACES; ++face) occupied[face] = 0;
  FOR_EACH_BIT(group, groups) {
    uint16 joined = rows[group];
    for (uint sample = 1; sample < TILE; ++sample) joined |= rows[sample * GROUPS + group];
    occupied[group / 2] |= joinElements(select((uint16)(0), rowBits, joined != 0))
                           << group % 2 * GROUP_ROWS;
  }
}

inline void mergeMasks(const Tile* tile, __global const float* spheres, uint sphereCount,
                       const SphereTable* table, __local uint* room, __local uint* rows,
                       uint* occupied) {
  const uint stride = sphereStride(sphereCount);
  __local uint* lists = room + LIST_SIZE;
  uint sizes[GROUPS], all = 0;
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += SPHERES_AT_ONCE) {
    const uint count = min((uint)SPHERES_AT_ONCE, sphereCount - first);
    findTableEntries(tile, spheres, stride, first, count, table->entries, room);
    const uint groups = listGroups(room, count, lists, sizes);
    all |= groups;
    FOR_EACH_BIT(group, groups)
      addList((__local uint16*)rows + group, lists + group * LIST_SIZE, sizes[group],
              (__global const uint16*)table->groups);
  }
  occupyRows((__local const uint16*)rows, all, occupied);
}
#endif

HAARLIGHT_KERNEL void mergeBitCubes(__global const float4* restrict positions,
                                    __global const float4* restrict normals,
                                    __global const float* restrict spheres,
                                    const uint sphereCount,
                                    __global const uint* restrict tableEntries,
                                    __global const uint* restrict tableGroups,
                                    __global uint* restrict bitCubes) {
  SAMPLE_LOCAL(uint, room, MERGE_ROOM);
  SAMPLE_LOCAL(uint, rows, TILE * BIT_CUBE_ROWS);
  const Tile tile = loadTile(positions, normals);
  const SphereTable table = {tableEntries, tableGroups};
  uint occupied[FACES];
  mergeMasks(&tile, spheres, sphereCount, &table, room, rows, occupied);
  storeRows(rows, bitCubes + FIRST_OF_TILE * BIT_CUBE_ROWS);
}
