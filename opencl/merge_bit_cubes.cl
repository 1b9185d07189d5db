// Step 1: the union of all spheres' visibility cubes, per sample.
//
// Lane j keeps row j of each of the six faces. Spheres are taken 32 at a time: each lane finds the
// table entry of one of them, then all lanes read the rows of all 32. Faces that a mask leaves
// empty are not read. A group of fewer than 32 is filled up with the last sphere, which changes
// nothing in a union.

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

  uint rows[FACES][LANES_PER_ITEM];
  for (uint face = 0; face < FACES; ++face)
    FOR_EACH_LANE(lane) OF_LANE(rows[face], lane) = 0;

  for (uint first = 0; first < sphereCount; first += LANES) {
    findTableEntries(spheres, sphereCount, first, position, normal, seen, entries);
    FOR_EACH_LANE(lane) faces[lane] = occupiedFaces[entries[lane]];
    LANE_BARRIER();
    for (uint i = 0; i < LANES; ++i) {
      __global const uint* mask = sphereTable + (size_t)entries[i] * BIT_CUBE_ROWS;
      for (uint face = 0; face < FACES; ++face) {
        if ((faces[i] >> face & 1) == 0) continue;
        FOR_EACH_LANE(lane) OF_LANE(rows[face], lane) |= mask[face * FACE_SIZE + lane];
      }
    }
    LANE_BARRIER();
  }

  for (uint face = 0; face < FACES; ++face)
    FOR_EACH_LANE(lane)
      bitCubes[sample * BIT_CUBE_ROWS + face * FACE_SIZE + lane] = OF_LANE(rows[face], lane);
}
