// Step 1 without the table: the union of all spheres' exact visibility cubes, per sample.
//
// With one lane an item, spheres are taken 32 at a time: each lane prepares one of them, then all
// lanes test their rows, row j of each face, against all 32. With all lanes, 16 samples test each row
// against a sphere, but for rows that are blocked for all of them already.

#if LANES_PER_ITEM == 1
// Caps and the faces they reach.
#define CAP_FLOATS (6 * LANES)

inline uint rowBits(const FaceCaps* caps, int row) {
  const Rows rows = rowsAt(caps, centerCoordinate(row));
  if (!mayBeBlocked(rows)) return 0;
  if (haveSafeEnds(caps)) return intervalOfRow(caps, rows);
  return holdAxis(caps) ? oneSidedRow(caps, rows) : rowBitsByBisection(rows);
}

// The union for one sample; `room` is for CAP_FLOATS numbers.
inline void mergeCaps(const Tile* tile, __global const float* spheres, uint sphereCount,
                      __local float* room, __local uint* rows, uint* occupied) {
  const uint stride = sphereStride(sphereCount);
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += LANES) {
    const Caps own = capsOf(seeSpheres(tile, spheres, stride, first));
    room[FIRST_LANE] = own.x;
    room[FIRST_LANE + LANES] = own.y;
    room[FIRST_LANE + 2 * LANES] = own.z;
    room[FIRST_LANE + 3 * LANES] = own.rim;
    room[FIRST_LANE + 4 * LANES] = own.rimRoot;
    room[FIRST_LANE + 5 * LANES] = as_float(reachedFaces(own.x, own.y, own.z, own.rim));
    LANE_BARRIER();
    const uint count = min((uint)LANES, sphereCount - first);
    for (uint i = 0; i < count; ++i) {
      const Caps caps = {room[i], room[i + LANES], room[i + 2 * LANES], room[i + 3 * LANES],
                         room[i + 4 * LANES]};
      const uint faces = as_uint(room[i + 5 * LANES]);
      for (uint face = 0; face < FACES; ++face)
        if (faces >> face & 1) {
          const FaceCaps onThis = onFace(face, &caps);
          rows[face * FACE_SIZE + FIRST_LANE] |= rowBits(&onThis, FIRST_LANE);
        }
    }
    LANE_BARRIER();
  }
  occupyAllRows(occupied);
}
#else
#define CAP_FLOATS (REACH_VECTORS * SPHERES_AT_ONCE + BIT_CUBE_ROWS)

// Adds the caps of one sphere to some rows of a face, of all samples.
inline void addCaps(const FaceCaps* caps, uint open, __local LaneUint* rows) {
  const LaneInt safe = haveSafeEnds(caps);
  if (joinElements(TO_LANE_UINT(~safe)) == 0) {
    FOR_EACH_BIT(row, open)
      rows[row] |= intervalOfRow(caps, rowsAt(caps, centerCoordinate((LaneInt)(int)row)));
    return;
  }
  const LaneInt oneSided = holdAxis(caps) & ~safe, other = ~(safe | oneSided);
  const bool anyOneSided = joinElements(TO_LANE_UINT(oneSided)) != 0;
  const bool anyOther = joinElements(TO_LANE_UINT(other)) != 0;
  const LaneInt reached = ~(isBeyondEdge(caps->major, caps->alongT, caps->alongS, caps->rim) |
                            isBeyondEdge(caps->major, caps->alongS, caps->alongT, caps->rim));
  FOR_EACH_BIT(row, open) {
    const Rows own = rowsAt(caps, centerCoordinate((LaneInt)(int)row));
    LaneUint bits = intervalOfRow(caps, own);
    if (anyOneSided) bits = select(bits, oneSidedRow(caps, own), oneSided);
    if (anyOther)
      bits = select(bits, rowBitsByBisection(own) & TO_LANE_UINT(reached & mayBeBlocked(own)), other);
    rows[row] |= bits;
  }
}

// A tile's bit cubes while they grow: rows row * 16 + sample, and of every row what all samples have
// blocked, as of the last block of spheres.
typedef struct {
  __local LaneUint* rows;
  __local uint* covered;
} TileRoom;

// Adds a sphere's caps to the faces it reaches; `reached` is its element in reachedByTile()'s vectors.
// Notes the rows that may have grown, face by face.
inline void addSphere(const Caps* caps, __local const uint* reached, const TileRoom* room,
                      uint* touched) {
  FOR_EACH_BIT(face, reached[0]) {
    const uint open =
        openRows(reached[SPHERES_AT_ONCE * (1 + face)], room->covered + face * FACE_SIZE);
    if (open == 0) continue;
    const FaceCaps own = onFace(face, caps);
    addCaps(&own, open, room->rows + face * FACE_SIZE);
    touched[face] |= open;
  }
}

inline void coverTouchedRows(const TileRoom* room, const uint* touched) {
  for (uint face = 0; face < FACES; ++face)
    FOR_EACH_BIT(row, touched[face])
      room->covered[face * FACE_SIZE + row] = meetElements(room->rows[face * FACE_SIZE + row]);
}

// The unions for a tile.
inline void mergeCaps(const Tile* tile, __global const float* spheres, uint sphereCount,
                      __local float* reachRoom, __local uint* rows, uint* occupied) {
  const uint stride = sphereStride(sphereCount);
  const TileBall ball = ballOf(tile);
  __local const uint* reached = (__local const uint*)reachRoom;
  const TileRoom room = {(__local LaneUint*)rows,
                         (__local uint*)reachRoom + REACH_VECTORS * SPHERES_AT_ONCE};
  clearRows(rows);
  for (uint row = 0; row < BIT_CUBE_ROWS; ++row) room.covered[row] = 0;
  for (uint face = 0; face < FACES; ++face) occupied[face] = 0;
  for (uint first = 0; first < sphereCount; first += SPHERES_AT_ONCE) {
    uint touched[FACES] = {0, 0, 0, 0, 0, 0};
    reachedByTile(&ball, spheres + first, stride, (__local LaneInt*)reachRoom);
    const uint count = min((uint)SPHERES_AT_ONCE, sphereCount - first);
    for (uint i = 0; i < count; ++i) {
      if (reached[i] == 0) continue;
      const Caps caps = capsOf(seeSphere(tile, spheres, stride, first + i));
      addSphere(&caps, reached + i, &room, touched);
    }
    for (uint face = 0; face < FACES; ++face) occupied[face] |= touched[face];
    if (first + SPHERES_AT_ONCE < sphereCount) coverTouchedRows(&room, touched);
  }
}
#endif

HAARLIGHT_KERNEL void mergeBitCubesExactly(__global const float4* restrict positions,
                                           __global const float4* restrict normals,
                                           __global const float* restrict spheres,
                                           const uint sphereCount,
                                           __global uint* restrict bitCubes) {
  SAMPLE_LOCAL(float, room, CAP_FLOATS);
  SAMPLE_LOCAL(uint, rows, TILE * BIT_CUBE_ROWS);
  const Tile tile = loadTile(positions, normals);
  uint occupied[FACES];
  mergeCaps(&tile, spheres, sphereCount, room, rows, occupied);
  storeRowsOfTile(rows, bitCubes + FIRST_OF_TILE * BIT_CUBE_ROWS);
}
