// Step 1 without the table: the union of all spheres' exact visibility cubes, per sample. Twin of
// src/visibility/exact_visibility.cpp: the same operations in the same order, since they decide
// bits.
//
// Spheres are taken 32 at a time: each lane prepares one of them, then all lanes test their rows, row
// j of each face, against all 32.

// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
// so that no texel is lost.
#define CAUTION 1.00001f

// A sphere seen from a sample: vector to its centre and d^2 cos^2 alpha.
struct Caps {
  float x, y, z, rim;
};

__device__ inline Caps capsOf(SeenSpheres seen) {
  const float distanceSquared = (seen.x * seen.x + seen.y * seen.y) + seen.z * seen.z;
  const float radiusSquared = seen.radius * seen.radius;
  const float depth = fminf(seen.height, 0.0f);
  const float limit = float(HORIZON_FACTOR) * depth * depth;
  const Caps caps = {seen.x, seen.y, seen.z,
                     fmaxf(fmaxf(distanceSquared - radiusSquared, 0.0f), limit)};
  return caps;
}

// Caps on a face: components of the vector to the centre along the face's direction and its s and t
// axes, and what all rows of the face need for the ends of their intervals.
struct FaceCaps {
  float major, alongS, alongT, rim;
  float leading;         // rim - alongS^2
  float inverseLeading;  // 1 / |leading|, nearly
};

__device__ inline float nearInverseRoot(float x) {
  float inverse = __uint_as_float(0x5f3759dfu - (__float_as_uint(x) >> 1));
  const float part = 0.5f * x;
  inverse = inverse * (1.5f - part * inverse * inverse);
  return inverse * (1.5f - part * inverse * inverse);
}

__device__ inline FaceCaps faceCaps(float major, float alongS, float alongT, float rim) {
  const float leading = rim - alongS * alongS;
  const float size = fabsf(leading), rough = nearInverseRoot(size);
  const float inverse = rough * (1.5f - 0.5f * size * rough * rough);
  const FaceCaps caps = {major, alongS, alongT, rim, leading, inverse * inverse};
  return caps;
}

__device__ inline FaceCaps onFace(uint face, const Caps* caps) {
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
__device__ inline bool haveSafeEnds(const FaceCaps* caps) {
  const float height = fabsf(caps->major) + fabsf(caps->alongT);
  const float most = 250.0f * caps->leading;
  return caps->leading > 1e-10f && caps->rim < 1e15f && 64.0f * caps->leading > caps->rim &&
         height * height * caps->rim < most * most;
}

// Coordinate of the centre of a row or column.
__device__ inline float centerCoordinate(int index) {
  return float(2 * index + 1 - FACE_SIZE) * 0.03125f;
}

// Whether the lane's cap reaches neither beyond the face's rows nor beyond its columns (`alongT`,
// `alongS` exchanged). By Cauchy's inequality
// (c.D)^2 / |c|^2 <= (major + t alongT)^2 / (1 + t^2) + alongS^2,
// which is largest at t = 1 when the sphere's centre is beyond the face's edge.
__device__ inline bool isBeyondEdge(float major, float alongT, float alongS, float rim) {
  const float atEdge = fmaxf(major + fabsf(alongT), 0.0f);
  const float bound = 0.5f * (atEdge * atEdge) + alongS * alongS;
  return fabsf(alongT) > major && bound * CAUTION < rim;
}

// Bit f is set when face f may be reached. The signs of components along s and t do not matter here.
__device__ inline uint reachedFaces(float x, float y, float z, float rim) {
  uint faces = 0;
#define REACH(face, major, s, t) \
  if (!isBeyondEdge(major, t, s, rim) && !isBeyondEdge(major, s, t, rim)) faces |= 1u << (face);
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
__device__ inline bool holdAxis(const FaceCaps* caps) {
  return caps->leading < -1e-10f && caps->rim < 1e15f && 64.0f * caps->leading < -caps->rim;
}

// A row of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
struct Rows {
  float atCenter, lengthSquared, alongS, rim;
};

__device__ inline Rows rowsAt(const FaceCaps* caps, float t) {
  const Rows rows = {caps->major + t * caps->alongT, 1.0f + t * t, caps->alongS, caps->rim};
  return rows;
}

__device__ inline bool isBlocked(Rows rows, int column) {
  const float s = centerCoordinate(column);
  const float dotProduct = rows.atCenter + s * rows.alongS;
  return dotProduct >= 0.0f && dotProduct * dotProduct >= (rows.lengthSquared + s * s) * rows.rim;
}

// By Cauchy's inequality (c.D)^2 <= (atCenter^2 / lengthSquared + alongS^2) |c|^2.
__device__ inline bool mayBeBlocked(Rows rows) {
  const float ahead = fmaxf(rows.atCenter, 0.0f);
  const float bound = ahead * ahead + rows.alongS * rows.alongS * rows.lengthSquared;
  return bound * CAUTION >= rows.lengthSquared * rows.rim;
}

// Column of the place where the angle to the sphere's centre is least.
__device__ inline int nearestColumn(Rows rows) {
  const float place = rows.alongS * rows.lengthSquared;
  int column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const float border = float(column + step - 16) * 0.0625f * rows.atCenter;
    column = place >= border ? column + step : column;
  }
  const int end = rows.alongS > 0.0f ? FACE_SIZE - 1 : 0;
  return rows.atCenter > 0.0f ? column : end;
}

// A blocked column, if there is one; else any.
__device__ inline int blockedColumn(Rows rows) {
  const int nearest = nearestColumn(rows);
  const int left = max(nearest - 1, 0), right = min(nearest + 1, FACE_SIZE - 1);
  return isBlocked(rows, nearest) ? nearest : isBlocked(rows, left) ? left : right;
}

__device__ inline uint columnBits(int first, int last) {
  return (~0u << first) & (~0u >> (FACE_SIZE - 1 - last));
}

// The ends of the interval by bisection with the test itself.
__device__ inline uint rowBitsByBisection(Rows rows) {
  const int inside = blockedColumn(rows);
  int first = inside, last = inside;
  for (int step = 16; step > 0; step /= 2) {
    first = first >= step && isBlocked(rows, first - step) ? first - step : first;
    last = last + step < FACE_SIZE && isBlocked(rows, last + step) ? last + step : last;
  }
  return isBlocked(rows, inside) ? columnBits(first, last) : 0u;
}

// From -1 to 32.
__device__ inline int nearestColumnTo(float place) {
  const float low = -1.0f, high = float(FACE_SIZE);
  return int(fminf(fmaxf(place, low), high) + 1.5f) - 1;
}

// The interval from the roots of (c.D)^2 = |c|^2 rim, a quadratic in s. A root is so near to the true
// one that all columns but the nearest are clear; that one is left to the test.
__device__ inline uint intervalOfRow(const FaceCaps* caps, Rows rows) {
  const float discriminant =
      caps->rim * (rows.atCenter * rows.atCenter - rows.lengthSquared * caps->leading);
  const float positive = fmaxf(discriminant, 1e-30f);
  const float scale = 16.0f * caps->inverseLeading;  // columns per s, over leading
  const float reach = positive * nearInverseRoot(positive) * scale;
  const float middle = 15.5f + (rows.atCenter * rows.alongS) * scale;
  const int nearBegin = nearestColumnTo(middle - reach), nearEnd = nearestColumnTo(middle + reach);
  const int first = max(isBlocked(rows, nearBegin) ? nearBegin : nearBegin + 1, 0),
            last = min(isBlocked(rows, nearEnd) ? nearEnd : nearEnd - 1, FACE_SIZE - 1);
  return first <= last && rows.atCenter > 0.0f ? columnBits(first, last) : 0;
}

// Where a cap holds one end of the s axis, all columns from the root on that side: the root is
// (lengthSquared rim - atCenter^2) / (product + root) or (root - product) / |leading|, of which one
// takes no difference of nearly equal numbers. s runs towards the held end here.
__device__ inline uint oneSidedRow(const FaceCaps* caps, Rows rows) {
  const bool turned = rows.alongS < 0.0f;
  const float product = rows.atCenter * fabsf(rows.alongS), square = rows.atCenter * rows.atCenter;
  const float discriminant =
      fmaxf(caps->rim * (square - rows.lengthSquared * caps->leading), 1e-30f);
  const float root = discriminant * nearInverseRoot(discriminant);
  const float inverse = nearInverseRoot(fmaxf(product + root, 1e-30f));
  const float ahead = (rows.lengthSquared * caps->rim - square) * (inverse * inverse),
              behind = (root - product) * caps->inverseLeading;
  const float begin = product > 0.0f ? ahead : behind;
  const int near = nearestColumnTo(15.5f + 16.0f * begin);
  const int column = turned ? FACE_SIZE - 1 - near : near;
  const int first = max(isBlocked(rows, column) ? near : near + 1, 0);
  const uint all = ~0u, shift = uint(min(first, FACE_SIZE - 1));
  return first < FACE_SIZE ? (turned ? all >> shift : all << shift) : 0;
}

// Caps and the faces they reach.
#define CAP_FLOATS (5 * LANES)

__device__ inline uint rowBits(const FaceCaps* caps, int row) {
  const Rows rows = rowsAt(caps, centerCoordinate(row));
  if (!mayBeBlocked(rows)) return 0;
  if (haveSafeEnds(caps)) return intervalOfRow(caps, rows);
  return holdAxis(caps) ? oneSidedRow(caps, rows) : rowBitsByBisection(rows);
}

// The union for one sample; `room` is for CAP_FLOATS numbers.
__device__ inline uint mergeCaps(const Tile* tile, const float* spheres, uint sphereCount,
                                 float* room, uint* rows) {
  const uint stride = sphereStride(sphereCount);
  clearRows(rows);
  for (uint first = 0; first < sphereCount; first += LANES) {
    const Caps own = capsOf(seeSpheres(tile, spheres, stride, first));
    room[LANE] = own.x;
    room[LANE + LANES] = own.y;
    room[LANE + 2 * LANES] = own.z;
    room[LANE + 3 * LANES] = own.rim;
    room[LANE + 4 * LANES] = __uint_as_float(reachedFaces(own.x, own.y, own.z, own.rim));
    LANE_BARRIER();
    const uint count = min(uint(LANES), sphereCount - first);
    for (uint i = 0; i < count; ++i) {
      const Caps caps = {room[i], room[i + LANES], room[i + 2 * LANES], room[i + 3 * LANES]};
      const uint faces = __float_as_uint(room[i + 4 * LANES]);
      for (uint face = 0; face < FACES; ++face)
        if (faces >> face & 1) {
          const FaceCaps onThis = onFace(face, &caps);
          rows[face * FACE_SIZE + LANE] |= rowBits(&onThis, int(LANE));
        }
    }
    LANE_BARRIER();
  }
  return ALL_GROUPS;
}

HAARLIGHT_KERNEL void mergeBitCubesExactly(const float4* __restrict__ positions,
                                           const float4* __restrict__ normals,
                                           const float* __restrict__ spheres,
                                           const uint sphereCount,
                                           uint* __restrict__ bitCubes) {
  SAMPLE_LOCAL(float, room, CAP_FLOATS);
  SAMPLE_LOCAL(uint, rows, TILE * BIT_CUBE_ROWS);
  const Tile tile = loadTile(positions, normals);
  mergeCaps(&tile, spheres, sphereCount, room, rows);
  storeRowsOfTile(rows, bitCubes + FIRST_OF_TILE * BIT_CUBE_ROWS);
}
