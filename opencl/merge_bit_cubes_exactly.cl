// Step 1 without the table: the union of all spheres' exact visibility cubes, per sample. Twin of
// src/visibility/exact_visibility.cpp: the same operations in the same order, since they decide
// bits.
//
// With one lane an item, spheres are taken 32 at a time: each lane prepares one of them, then all
// lanes test their rows, row j of each face, against all 32. With all lanes, 16 samples test each row
// against a sphere.

// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
// so that no texel is lost.
#define CAUTION 1.00001f

// A sphere seen from a sample: vector to its centre and d^2 cos^2 alpha.
typedef struct {
  LaneFloat x, y, z, rim;
} Caps;

inline Caps capsOf(SeenSpheres seen) {
  const LaneFloat distanceSquared = (seen.x * seen.x + seen.y * seen.y) + seen.z * seen.z;
  const LaneFloat radiusSquared = seen.radius * seen.radius;
  const LaneFloat depth = fmin(seen.height, (LaneFloat)0.0f);
  const LaneFloat limit = (float)HORIZON_FACTOR * depth * depth;
  const Caps caps = {seen.x, seen.y, seen.z,
                     fmax(fmax(distanceSquared - radiusSquared, (LaneFloat)0.0f), limit)};
  return caps;
}

// Components along a face's direction and its s and t axes.
typedef struct {
  LaneFloat major, alongS, alongT;
} FaceComponents;

inline FaceComponents onFace(uint face, Caps caps) {
  const FaceComponents components[FACES] = {
      {caps.x, -caps.z, -caps.y}, {-caps.x, caps.z, -caps.y}, {caps.y, caps.x, caps.z},
      {-caps.y, caps.x, -caps.z}, {caps.z, caps.x, -caps.y},  {-caps.z, -caps.x, -caps.y}};
  return components[face];
}

// Coordinates of the centres of rows or columns.
inline LaneFloat centerCoordinate(LaneInt index) {
  return TO_LANE_FLOAT(2 * index + 1 - FACE_SIZE) * 0.03125f;
}

// Whether caps reach neither beyond the face's rows nor beyond its columns (`alongT`, `alongS`
// exchanged), a cap per lane. By Cauchy's inequality (c.D)^2 / |c|^2 <= (major + t alongT)^2 /
// (1 + t^2) + alongS^2, which is largest at t = 1 when the sphere's centre is beyond the face's edge.
inline LaneInt isBeyondEdge(LaneFloat major, LaneFloat alongT, LaneFloat alongS, LaneFloat rim) {
  const LaneFloat atEdge = fmax(major + fabs(alongT), (LaneFloat)0.0f);
  const LaneFloat bound = 0.5f * (atEdge * atEdge) + alongS * alongS;
  return (fabs(alongT) > major) & (bound * CAUTION < rim);
}

// Bit f is set when face f may be reached. The signs of components along s and t do not matter here.
inline LaneInt reachedFaces(LaneFloat x, LaneFloat y, LaneFloat z, LaneFloat rim) {
  LaneInt faces = 0;
#define REACH(face, major, s, t)                                                                \
  faces |= select((LaneInt)(1 << (face)), (LaneInt)0,                                           \
                  isBeyondEdge(major, t, s, rim) | isBeyondEdge(major, s, t, rim));
  REACH(0, x, z, y)
  REACH(1, -x, z, y)
  REACH(2, y, x, z)
  REACH(3, -y, x, z)
  REACH(4, z, x, y)
  REACH(5, -z, x, y)
#undef REACH
  return faces;
}

// Rows of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
typedef struct {
  LaneFloat atCenter, lengthSquared, alongS, rim;
} Rows;

inline Rows rowsAt(FaceComponents components, LaneFloat t, LaneFloat rim) {
  const Rows rows = {components.major + t * components.alongT, 1.0f + t * t, components.alongS, rim};
  return rows;
}

inline LaneInt isBlocked(Rows rows, LaneInt column) {
  const LaneFloat s = centerCoordinate(column);
  const LaneFloat dotProduct = rows.atCenter + s * rows.alongS;
  return (dotProduct >= 0.0f) &
         (dotProduct * dotProduct >= (rows.lengthSquared + s * s) * rows.rim);
}

// By Cauchy's inequality (c.D)^2 <= (atCenter^2 / lengthSquared + alongS^2) |c|^2.
inline LaneInt mayBeBlocked(Rows rows) {
  const LaneFloat ahead = fmax(rows.atCenter, (LaneFloat)0.0f);
  const LaneFloat bound = ahead * ahead + rows.alongS * rows.alongS * rows.lengthSquared;
  return bound * CAUTION >= rows.lengthSquared * rows.rim;
}

// Column of the place where the angle to the sphere's centre is least.
inline LaneInt nearestColumn(Rows rows) {
  const LaneFloat place = rows.alongS * rows.lengthSquared;
  LaneInt column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const LaneFloat border = TO_LANE_FLOAT(column + step - 16) * 0.0625f * rows.atCenter;
    column = select(column, column + step, place >= border);
  }
  const LaneInt end = select((LaneInt)0, (LaneInt)(FACE_SIZE - 1), (LaneInt)(rows.alongS > 0.0f));
  return select(end, column, rows.atCenter > 0.0f);
}

// A blocked column, if there is one; else any.
inline LaneInt blockedColumn(Rows rows) {
  const LaneInt nearest = nearestColumn(rows);
  const LaneInt left = max(nearest - 1, 0), right = min(nearest + 1, FACE_SIZE - 1);
  return select(select(right, left, isBlocked(rows, left)), nearest, isBlocked(rows, nearest));
}

inline LaneUint columnBits(LaneInt first, LaneInt last) {
  const LaneUint all = ~0u;
  return (all << TO_LANE_UINT(first)) & (all >> TO_LANE_UINT(FACE_SIZE - 1 - last));
}

// The ends of the interval by bisection with the test itself.
inline LaneUint rowBitsByBisection(Rows rows) {
  const LaneInt inside = blockedColumn(rows);
  LaneInt first = inside, last = inside;
  for (int step = 16; step > 0; step /= 2) {
    first = select(first, first - step, (first >= step) & isBlocked(rows, first - step));
    last = select(last, last + step, (last + step < FACE_SIZE) & isBlocked(rows, last + step));
  }
  return select((LaneUint)0, columnBits(first, last), isBlocked(rows, inside));
}

// 1 / sqrt(x) to some five digits: an estimate from the exponent and two steps of Newton's method. It
// decides no bit.
inline LaneFloat inverseRoot(LaneFloat x) {
  LaneFloat inverse = LANE_FLOAT_OF_BITS(0x5f3759dfu - (BITS_OF_LANE_FLOAT(x) >> 1));
  for (int step = 0; step < 2; ++step)
    inverse = inverse * (1.5f - 0.5f * x * inverse * inverse);
  return inverse;
}

// The ends from the roots of (c.D)^2 = |c|^2 rim, a quadratic in s. Rounding may put them into a
// wrong column, so they count only where the test itself agrees on both sides of them. Where products
// could leave float32, or the cap holds the face's s axis, ends are found by bisection.
inline LaneUint endsOfRow(Rows rows) {
  const LaneFloat leading = rows.rim - rows.alongS * rows.alongS;
  const LaneInt safe = (leading > 1e-10f) & (rows.rim < 1e15f);
  const LaneFloat inverseOfRoot = inverseRoot(leading);
  const LaneFloat scale = 16.0f * inverseOfRoot * inverseOfRoot;  // columns per s, over leading
  const LaneFloat discriminant =
      rows.rim * (rows.atCenter * rows.atCenter - rows.lengthSquared * leading);
  const LaneFloat positive = fmax(discriminant, (LaneFloat)1e-30f);
  const LaneFloat reach = positive * inverseRoot(positive) * scale;
  const LaneFloat middle = 15.5f + (rows.atCenter * rows.alongS) * scale;
  const LaneFloat low = (LaneFloat)-1.0f, high = (LaneFloat)FACE_SIZE;
  const LaneFloat begin = fmin(fmax(middle - reach, low), high),
                  end = fmin(fmax(middle + reach, low), high);
  const LaneInt first = max(TO_LANE_INT(ceil(begin)), (LaneInt)0),
                last = min(TO_LANE_INT(floor(end)), (LaneInt)(FACE_SIZE - 1));
  const LaneInt atFirst = isBlocked(rows, min(first, (LaneInt)(FACE_SIZE - 1))),
                atLast = isBlocked(rows, max(last, (LaneInt)0)),
                before = (first > 0) & isBlocked(rows, first - 1),
                after = (last < FACE_SIZE - 1) & isBlocked(rows, last + 1);
  const LaneInt empty = first > last;
  const LaneInt wrong = select(!(atFirst & atLast & !before & !after), atFirst | atLast, empty);
  if (ANY_LANE(wrong | !safe)) return rowBitsByBisection(rows);
  return select(columnBits(first, last), (LaneUint)0, empty);
}

inline LaneUint rowBits(Rows rows) {
  const LaneInt mayBe = mayBeBlocked(rows);
  return ANY_LANE(mayBe) ? select((LaneUint)0, endsOfRow(rows), mayBe) : (LaneUint)0;
}

#if LANES_PER_ITEM == 1
// Caps and the faces they reach.
#define CAP_FLOATS (5 * LANES)

// The union for one sample; `room` is for CAP_FLOATS numbers.
inline uint mergeCaps(const Tile* tile, __global const float* spheres, uint sphereCount,
                      __local float* room, __local uint* rows) {
  const uint stride = sphereStride(sphereCount);
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += LANES) {
    const Caps own = capsOf(seeSpheres(tile, spheres, stride, first));
    room[FIRST_LANE] = own.x;
    room[FIRST_LANE + LANES] = own.y;
    room[FIRST_LANE + 2 * LANES] = own.z;
    room[FIRST_LANE + 3 * LANES] = own.rim;
    room[FIRST_LANE + 4 * LANES] = as_float(reachedFaces(own.x, own.y, own.z, own.rim));
    LANE_BARRIER();
    const uint count = min((uint)LANES, sphereCount - first);
    for (uint i = 0; i < count; ++i) {
      const Caps caps = {room[i], room[i + LANES], room[i + 2 * LANES], room[i + 3 * LANES]};
      const uint faces = as_uint(room[i + 4 * LANES]);
      for (uint face = 0; face < FACES; ++face)
        if (faces >> face & 1)
          rows[face * FACE_SIZE + FIRST_LANE] |=
              rowBits(rowsAt(onFace(face, caps), centerCoordinate(FIRST_LANE), caps.rim));
    }
    LANE_BARRIER();
  }
  return ALL_GROUPS;
}
#else
#define CAP_FLOATS 1

// The unions for a tile, row by row: row * 16 + sample.
inline uint mergeCaps(const Tile* tile, __global const float* spheres, uint sphereCount,
                      __local float* room, __local uint* rows) {
  const uint stride = sphereStride(sphereCount);
  uint occupied = 0;
  clearRows(rows);
  for (uint sphere = 0; sphere < sphereCount; ++sphere) {
    const Caps caps = capsOf(seeSphere(tile, spheres, stride, sphere));
    uint reached = joinElements(TO_LANE_UINT(reachedFaces(caps.x, caps.y, caps.z, caps.rim)));
    for (; reached; reached &= reached - 1) {
      const uint face = 31 - clz(reached & -reached);
      const FaceComponents components = onFace(face, caps);
      occupied |= 3u << 2 * face;
      for (uint row = 0; row < FACE_SIZE; ++row)
        ((__local LaneUint*)rows)[face * FACE_SIZE + row] |=
            rowBits(rowsAt(components, centerCoordinate((LaneInt)row), caps.rim));
    }
  }
  return occupied;
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
  mergeCaps(&tile, spheres, sphereCount, room, rows);
  storeRowsOfTile(rows, bitCubes + FIRST_OF_TILE * BIT_CUBE_ROWS);
}
