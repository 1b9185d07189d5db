// Step 1: the union of all spheres' visibility cubes, per sample.
//
// Spheres are taken 32 at a time: each lane finds the table entry of one of them, then all lanes
// read the rows of all 32. Faces that a mask leaves empty are not read. A group of fewer than 32 is
// filled up with the last sphere, which changes nothing in a union.

// The rows of a sample that a work-item keeps. With one lane: row j of each face, for lane j. With
// all lanes: 16 rows a vector, in two copies, to which spheres go in turn, so that a sphere need not
// wait until the rows of the one before are stored.
#if LANES_PER_ITEM == 1
typedef uint UnionRow;
#define UNION_ROWS FACES

inline void addMask(UnionRow* rows, uint sphere, __global const uint* mask, uint faces) {
  for (uint face = 0; face < FACES; ++face)
    if (faces >> face & 1) rows[face] |= mask[face * FACE_SIZE + FIRST_LANE];
}

inline void storeRows(const UnionRow* rows, __global uint* bitCube) {
  for (uint face = 0; face < FACES; ++face) bitCube[face * FACE_SIZE + FIRST_LANE] = rows[face];
}
#else
typedef uint16 UnionRow;
#define UNION_ROWS (2 * 2 * FACES)

inline void addMask(UnionRow* rows, uint sphere, __global const uint* mask, uint faces) {
  UnionRow* copy = rows + (sphere & 1) * 2 * FACES;
  while (faces) {
    const uint face = 31 - clz(faces);
    faces ^= 1u << face;
    copy[2 * face] |= vload16(2 * face, mask);
    copy[2 * face + 1] |= vload16(2 * face + 1, mask);
  }
}

inline void storeRows(const UnionRow* rows, __global uint* bitCube) {
  for (uint i = 0; i < 2 * FACES; ++i) vstore16(rows[i] | rows[2 * FACES + i], i, bitCube);
}
#endif

HAARLIGHT_KERNEL void mergeBitCubes(__global const float4* restrict positions,
                                    __global const float4* restrict normals,
                                    __global const float4* restrict spheres,
                                    const uint sphereCount,
                                    __global const uint* restrict sphereTable,
                                    __global const uchar* restrict occupiedFaces,
                                    __global uint* restrict bitCubes) {
  SAMPLE_LOCAL(float, seen, 4 * LANES);
  SAMPLE_LOCAL(uint, entries, LANES);
  SAMPLE_LOCAL(uint, faces, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];
  UnionRow rows[UNION_ROWS];
  for (uint i = 0; i < UNION_ROWS; ++i) rows[i] = 0;

  for (uint first = 0; first < sphereCount; first += LANES) {
    findTableEntries(spheres, sphereCount, first, position, normal, seen, entries);
    FOR_EACH_LANE(lane) faces[lane] = occupiedFaces[entries[lane]];
    LANE_BARRIER();
    for (uint i = 0; i < LANES; ++i) {
      addMask(rows, i, sphereTable + (size_t)entries[i] * BIT_CUBE_ROWS, faces[i]);
    }
    LANE_BARRIER();
  }
  storeRows(rows, bitCubes + sample * BIT_CUBE_ROWS);
}
