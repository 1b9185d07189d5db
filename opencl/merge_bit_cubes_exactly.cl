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

// Caps on a face: components of the vector to the centre along the face's direction and its s and t
// axes, and what all rows of the face need for the ends of their intervals.
typedef struct {
  LaneFloat major, alongS, alongT, rim;
  LaneFloat leading;         // rim - alongS^2
  LaneFloat inverseLeading;  // 1 / |leading|, nearly
} FaceCaps;

inline LaneFloat nearInverseRoot(LaneFloat x) {
  LaneFloat inverse = LANE_FLOAT_OF_BITS(0x5f3759dfu - (BITS_OF_LANE_FLOAT(x) >> 1));
  const LaneFloat part = 0.5f * x;
  inverse = inverse * (1.5f - part * inverse * inverse);
  return inverse * (1.5f - part * inverse * inverse);
}

inline FaceCaps faceCaps(LaneFloat major, LaneFloat alongS, LaneFloat alongT, LaneFloat rim) {
  const LaneFloat leading = rim - alongS * alongS;
  const LaneFloat size = fabs(leading), rough = nearInverseRoot(size);
  const LaneFloat inverse = rough * (1.5f - 0.5f * size * rough * rough);
  const FaceCaps caps = {major, alongS, alongT, rim, leading, inverse * inverse};
  return caps;
}

inline FaceCaps onFace(uint face, const Caps* caps) {
  switch (face) {
    case 0: return faceCaps(caps->x, -caps->z, -caps->y, caps->rim);
    case 1: return faceCaps(-caps->x, caps->z, -caps->y, caps->rim);
    case 2: return faceCaps(caps->y, caps->x, caps->z, caps->rim);
    case 3: return faceCaps(-caps->y, caps->x, -caps->z, caps->rim);
    case 4: return faceCaps(caps->z, caps->x, -caps->y, caps->rim);
    default: return faceCaps(-caps->z, -caps->x, -caps->y, caps->rim);
  }
}

// Whether the ends of intervals that intervalOfRow() finds are less than half a column wrong, and
// products stay within float32. Roots are within 4,000 columns of the face's centre then, and neither
// the rounding of `leading` nor a relative error of 10^-5 moves them by more than a tenth.
inline LaneInt haveSafeEnds(const FaceCaps* caps) {
  const LaneFloat height = fabs(caps->major) + fabs(caps->alongT);
  const LaneFloat most = 250.0f * caps->leading;
  return (caps->leading > 1e-10f) & (caps->rim < 1e15f) & (64.0f * caps->leading > caps->rim) &
         (height * height * caps->rim < most * most);
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

// Whether caps hold the direction of the face's s axis, clearly, or that against it: rows have one end
// then, and oneSidedRow() finds it.
inline LaneInt holdAxis(const FaceCaps* caps) {
  return (caps->leading < -1e-10f) & (caps->rim < 1e15f) & (64.0f * caps->leading < -caps->rim);
}

// A row of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
typedef struct {
  LaneFloat atCenter, lengthSquared, alongS, rim;
} Rows;

inline Rows rowsAt(const FaceCaps* caps, LaneFloat t) {
  const Rows rows = {caps->major + t * caps->alongT, 1.0f + t * t, caps->alongS, caps->rim};
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

// From -1 to 32.
inline LaneInt nearestColumnTo(LaneFloat place) {
  const LaneFloat low = (LaneFloat)-1.0f, high = (LaneFloat)FACE_SIZE;
  return TO_LANE_INT(fmin(fmax(place, low), high) + 1.5f) - 1;
}

// The interval from the roots of (c.D)^2 = |c|^2 rim, a quadratic in s. A root is so near to the true
// one that all columns but the nearest are clear; that one is left to the test.
inline LaneUint intervalOfRow(const FaceCaps* caps, Rows rows) {
  const LaneFloat discriminant =
      caps->rim * (rows.atCenter * rows.atCenter - rows.lengthSquared * caps->leading);
  const LaneFloat positive = fmax(discriminant, (LaneFloat)1e-30f);
  const LaneFloat scale = 16.0f * caps->inverseLeading;  // columns per s, over leading
  const LaneFloat reach = positive * nearInverseRoot(positive) * scale;
  const LaneFloat middle = 15.5f + (rows.atCenter * rows.alongS) * scale;
  const LaneInt nearBegin = nearestColumnTo(middle - reach), nearEnd = nearestColumnTo(middle + reach);
  const LaneInt first = max(select(nearBegin + 1, nearBegin, isBlocked(rows, nearBegin)), (LaneInt)0),
                last = min(select(nearEnd - 1, nearEnd, isBlocked(rows, nearEnd)),
                           (LaneInt)(FACE_SIZE - 1));
  return select((LaneUint)0, columnBits(first, last), (first <= last) & (rows.atCenter > 0.0f));
}

// Where a cap holds one end of the s axis, all columns from the root on that side: the root is
// (lengthSquared rim - atCenter^2) / (product + root) or (root - product) / |leading|, of which one
// takes no difference of nearly equal numbers. s runs towards the held end here.
inline LaneUint oneSidedRow(const FaceCaps* caps, Rows rows) {
  const LaneInt turned = rows.alongS < 0.0f;
  const LaneFloat product = rows.atCenter * fabs(rows.alongS), square = rows.atCenter * rows.atCenter;
  const LaneFloat discriminant =
      fmax(caps->rim * (square - rows.lengthSquared * caps->leading), (LaneFloat)1e-30f);
  const LaneFloat root = discriminant * nearInverseRoot(discriminant);
  const LaneFloat inverse = nearInverseRoot(fmax(product + root, (LaneFloat)1e-30f));
  const LaneFloat ahead = (rows.lengthSquared * caps->rim - square) * (inverse * inverse),
                  behind = (root - product) * caps->inverseLeading;
  const LaneFloat begin = select(behind, ahead, (LaneInt)(product > 0.0f));
  const LaneInt near = nearestColumnTo(15.5f + 16.0f * begin);
  const LaneInt column = select(near, FACE_SIZE - 1 - near, turned);
  const LaneInt first = max(select(near + 1, near, isBlocked(rows, column)), (LaneInt)0);
  const LaneUint all = ~0u, shift = TO_LANE_UINT(min(first, (LaneInt)(FACE_SIZE - 1)));
  return select((LaneUint)0, select(all << shift, all >> shift, turned),
                (LaneInt)(first < FACE_SIZE));
}

#if LANES_PER_ITEM == 1
// Caps and the faces they reach.
#define CAP_FLOATS (5 * LANES)

inline uint rowBits(const FaceCaps* caps, int row) {
  const Rows rows = rowsAt(caps, centerCoordinate(row));
  if (!mayBeBlocked(rows)) return 0;
  if (haveSafeEnds(caps)) return intervalOfRow(caps, rows);
  return holdAxis(caps) ? oneSidedRow(caps, rows) : rowBitsByBisection(rows);
}

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
        if (faces >> face & 1) {
          const FaceCaps onThis = onFace(face, &caps);
          rows[face * FACE_SIZE + FIRST_LANE] |= rowBits(&onThis, FIRST_LANE);
        }
    }
    LANE_BARRIER();
  }
  return ALL_GROUPS;
}
#else
#define CAP_FLOATS 1

// Rows that any of a tile's caps may reach.
typedef struct {
  int first, last;
} RowRange;

// A cap's rows, rounded down, from the roots of (atCenter^2 / lengthSquared + alongS^2) = rim, a quadratic in t, and a
// quarter of a row more. Where the cap holds the t axis, nearly, all rows.
inline RowRange reachedRows(const FaceCaps* caps, LaneInt reached, LaneInt safe) {
  const LaneFloat square = caps->alongT * caps->alongT, leading = caps->leading - square;
  const LaneFloat beyond = (caps->major * caps->major + square) - caps->leading;
  const LaneFloat inverse = nearInverseRoot(leading), scale = 16.0f * inverse * inverse;
  const LaneFloat discriminant = fmax(caps->leading * beyond, (LaneFloat)1e-30f);
  const LaneFloat reach = discriminant * nearInverseRoot(discriminant) * scale + 0.25f;
  const LaneFloat middle = 15.5f + (caps->major * caps->alongT) * scale;
  const LaneFloat low = (LaneFloat)0.0f, high = (LaneFloat)(FACE_SIZE - 1);
  const LaneInt known = (64.0f * leading > caps->rim) & safe;
  const LaneFloat first = select(low, fmin(fmax(middle - reach, low), high), known),
                  last = select(high, fmin(fmax(middle + reach, low), high), known);
  const RowRange range = {
      smallestElement(select((LaneInt)FACE_SIZE, TO_LANE_INT(first), reached)),
      -smallestElement(select((LaneInt)1, -TO_LANE_INT(last), reached))};
  return range;
}

// Adds the caps of one sphere to a face of all samples; tells which of its two groups that may fill.
inline uint addCaps(const FaceCaps* caps, LaneInt reached, __local LaneUint* rows) {
  const LaneInt safe = haveSafeEnds(caps);
  const RowRange range = reachedRows(caps, reached, safe);
  const LaneInt oneSided = holdAxis(caps) & !safe, other = reached & !safe & !oneSided;
  const bool anyOneSided = joinElements(TO_LANE_UINT(reached & oneSided)) != 0;
  const bool anyOther = joinElements(TO_LANE_UINT(other)) != 0;
  for (int row = range.first; row <= range.last; ++row) {
    const Rows own = rowsAt(caps, centerCoordinate((LaneInt)row));
    LaneUint bits = intervalOfRow(caps, own);
    if (anyOneSided) bits = select(bits, oneSidedRow(caps, own), oneSided);
    if (anyOther)
      bits = select(bits, select((LaneUint)0, rowBitsByBisection(own), mayBeBlocked(own)), other);
    rows[row] |= select((LaneUint)0, bits, reached);
  }
  return (range.first < GROUP_ROWS ? 1 : 0) | (range.last >= GROUP_ROWS ? 2 : 0);
}

// The unions for a tile, row by row: row * 16 + sample.
inline uint mergeCaps(const Tile* tile, __global const float* spheres, uint sphereCount,
                      __local float* room, __local uint* rows) {
  const uint stride = sphereStride(sphereCount);
  uint occupied = 0;
  clearRows(rows);
  for (uint sphere = 0; sphere < sphereCount; ++sphere) {
    const Caps caps = capsOf(seeSphere(tile, spheres, stride, sphere));
    const LaneInt faces = reachedFaces(caps.x, caps.y, caps.z, caps.rim);
    for (uint reached = joinElements(TO_LANE_UINT(faces)); reached; reached &= reached - 1) {
      const uint bit = reached & -reached, face = 31 - clz(bit);
      const FaceCaps own = onFace(face, &caps);
      occupied |= addCaps(&own, (faces & (LaneInt)bit) != 0,
                          (__local LaneUint*)rows + face * FACE_SIZE)
                  << 2 * face;
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
