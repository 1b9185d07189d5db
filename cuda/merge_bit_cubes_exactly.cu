// Step 1 without the table: the union of all spheres' exact visibility cubes, per sample.
//
// Spheres are taken 32 at a time: each lane prepares one of them, then all lanes test their rows, row
// j of each face, against all 32.

// Caps and the faces they reach.
#define CAP_FLOATS (6 * LANES)

__device__ inline uint rowBits(const FaceCaps* caps, int row) {
  const Rows rows = rowsAt(caps, centerCoordinate(row));
  if (!mayBeBlocked(rows)) return 0;
  if (haveSafeEnds(caps)) return intervalOfRow(caps, rows);
  return holdAxis(caps) ? oneSidedRow(caps, rows) : rowBitsByBisection(rows);
}

// The union for one sample; `room` is for CAP_FLOATS numbers.
__device__ inline void mergeCaps(const Tile* tile, const float* spheres, uint sphereCount,
                                 float* room, uint* rows, uint* occupied) {
  const uint stride = sphereStride(sphereCount);
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += LANES) {
    const Caps own = capsOf(seeSpheres(tile, spheres, stride, first));
    room[LANE] = own.x;
    room[LANE + LANES] = own.y;
    room[LANE + 2 * LANES] = own.z;
    room[LANE + 3 * LANES] = own.rim;
    room[LANE + 4 * LANES] = own.rimRoot;
    room[LANE + 5 * LANES] = __uint_as_float(reachedFaces(own.x, own.y, own.z, own.rim));
    LANE_BARRIER();
    const uint count = min(uint(LANES), sphereCount - first);
    for (uint i = 0; i < count; ++i) {
      const Caps caps = {room[i], room[i + LANES], room[i + 2 * LANES], room[i + 3 * LANES],
                         room[i + 4 * LANES]};
      const uint faces = __float_as_uint(room[i + 5 * LANES]);
      for (uint face = 0; face < FACES; ++face)
        if (faces >> face & 1) {
          const FaceCaps onThis = onFace(face, &caps);
          rows[face * FACE_SIZE + LANE] |= rowBits(&onThis, int(LANE));
        }
    }
    LANE_BARRIER();
  }
  occupyAllRows(occupied);
}

HAARLIGHT_KERNEL void mergeBitCubesExactly(const float4* __restrict__ positions,
                                           const float4* __restrict__ normals,
                                           const float* __restrict__ spheres,
                                           const uint sphereCount,
                                           uint* __restrict__ bitCubes) {
  SAMPLE_LOCAL(float, room, CAP_FLOATS);
  SAMPLE_LOCAL(uint, rows, TILE * BIT_CUBE_ROWS);
  const Tile tile = loadTile(positions, normals);
  uint occupied[FACES];
  mergeCaps(&tile, spheres, sphereCount, room, rows, occupied);
  storeRowsOfTile(rows, bitCubes + FIRST_OF_TILE * BIT_CUBE_ROWS);
}
