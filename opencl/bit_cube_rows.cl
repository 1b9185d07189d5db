// The bit cubes of a tile while they grow, in local memory: word face * 32 + row of every sample.
// Groups are 16 rows. Merging tells which rows may hold a set bit, as a word of row bits for every face.

#define GROUP_ROWS 16
#define GROUPS (BIT_CUBE_ROWS / GROUP_ROWS)
#define ALL_GROUPS ((1u << GROUPS) - 1)

#if LANES_PER_ITEM == 1
inline void occupyAllRows(uint* occupied) {
  for (uint face = 0; face < FACES; ++face) occupied[face] = ~0u;
}

inline void clearRows(__local uint* rows) {
  for (uint face = 0; face < FACES; ++face) rows[face * FACE_SIZE + FIRST_LANE] = 0;
}

inline void storeRows(__local const uint* rows, __global uint* bitCubes) {
  for (uint face = 0; face < FACES; ++face)
    bitCubes[face * FACE_SIZE + FIRST_LANE] = rows[face * FACE_SIZE + FIRST_LANE];
}

inline void storeRowsOfTile(__local const uint* rows, __global uint* bitCubes) {
  storeRows(rows, bitCubes);
}
#else
inline void clearRows(__local uint* rows) {
  for (uint i = 0; i < TILE * BIT_CUBE_ROWS / 16; ++i) ((__local uint16*)rows)[i] = (uint16)(0);
}

// Rows that lie sample by sample.
inline void storeRows(__local const uint* rows, __global uint* bitCubes) {
  for (uint i = 0; i < TILE * BIT_CUBE_ROWS / 16; ++i)
    ((__global uint16*)bitCubes)[i] = ((__local const uint16*)rows)[i];
}

// Rows that lie row by row.
inline void storeRowsOfTile(__local const uint* rows, __global uint* bitCubes) {
  for (uint sample = 0; sample < TILE; ++sample)
    for (uint row = 0; row < BIT_CUBE_ROWS; ++row)
      bitCubes[sample * BIT_CUBE_ROWS + row] = rows[row * TILE + sample];
}

inline uint joinElements(uint16 v) {
  return (((v.s0 | v.s1) | (v.s2 | v.s3)) | ((v.s4 | v.s5) | (v.s6 | v.s7))) |
         (((v.s8 | v.s9) | (v.sa | v.sb)) | ((v.sc | v.sd) | (v.se | v.sf)));
}

inline uint meetElements(uint16 v) {
  return (((v.s0 & v.s1) & (v.s2 & v.s3)) & ((v.s4 & v.s5) & (v.s6 & v.s7))) &
         (((v.s8 & v.s9) & (v.sa & v.sb)) & ((v.sc & v.sd) & (v.se & v.sf)));
}
#endif
