// The bit cube of a sample while it grows, in shared memory: word face * 32 + row. Groups are 16 rows.
// Merging tells which rows may hold a set bit, as a word of row bits for every face.

#define GROUP_ROWS 16
#define GROUPS (BIT_CUBE_ROWS / GROUP_ROWS)
#define ALL_GROUPS ((1u << GROUPS) - 1)

__device__ inline void occupyAllRows(uint* occupied) {
  for (uint face = 0; face < FACES; ++face) occupied[face] = ~0u;
}

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
