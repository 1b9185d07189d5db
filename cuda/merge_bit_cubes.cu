// Step 1: the union of all spheres' visibility cubes, per sample.
//
// Spheres are taken 32 at a time: each lane finds the table entry of one of them, then all lanes
// read the rows of all 32. Faces that a mask leaves empty are not read. A group of fewer than 32 is
// filled up with the last sphere, which changes nothing in a union.

// `rows` is row j of each face, for lane j.
__device__ inline void addMask(uint* rows, const uint* mask, uint faces) {
  for (uint face = 0; face < FACES; ++face)
    if (faces >> face & 1) rows[face] |= mask[face * FACE_SIZE + LANE];
}

__device__ inline void storeRows(const uint* rows, uint* bitCube) {
  for (uint face = 0; face < FACES; ++face) bitCube[face * FACE_SIZE + LANE] = rows[face];
}

HAARLIGHT_KERNEL void mergeBitCubes(const float4* __restrict__ positions,
                                    const float4* __restrict__ normals,
                                    const float4* __restrict__ spheres,
                                    const uint sphereCount,
                                    const uint* __restrict__ sphereTable,
                                    const uchar* __restrict__ occupiedFaces,
                                    uint* __restrict__ bitCubes) {
  SAMPLE_LOCAL(uint, entries, LANES);
  SAMPLE_LOCAL(uint, faces, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];

  uint rows[FACES];
  for (uint face = 0; face < FACES; ++face) rows[face] = 0;

  for (uint first = 0; first < sphereCount; first += LANES) {
    findTableEntries(spheres, sphereCount, first, position, normal, entries);
    faces[LANE] = occupiedFaces[entries[LANE]];
    LANE_BARRIER();
    for (uint i = 0; i < LANES; ++i) {
      addMask(rows, sphereTable + size_t(entries[i]) * BIT_CUBE_ROWS, faces[i]);
    }
    LANE_BARRIER();
  }
  storeRows(rows, bitCubes + sample * BIT_CUBE_ROWS);
}
