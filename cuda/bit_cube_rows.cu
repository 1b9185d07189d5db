// The bit cube of a sample while it grows, in shared memory: word face * 32 + row. Groups are 16 rows;
// merging tells which groups may hold a set bit.

#define GROUP_ROWS 16
#define GROUPS (BIT_CUBE_ROWS / GROUP_ROWS)
#define ALL_GROUPS ((1u << GROUPS) - 1)

__device__ inline void clearRows(uint* rows) {
  for (uint face = 0; face < FACES; ++face) rows[face * FACE_SIZE + LANE] = 0;
}

__device__ inline void storeRows(const uint* rows, uint* bitCubes) {
  for (uint face = 0; face < FACES; ++face)
    bitCubes[face * FACE_SIZE + LANE] = rows[face * FACE_SIZE + LANE];
}

__device__ inline void storeRowsOfTile(const uint* rows, uint* bitCubes) {
  storeRows(rows, bitCubes);
}
