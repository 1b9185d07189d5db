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

// Components along a face's direction and its s and t axes.
struct FaceComponents {
  float major, alongS, alongT;
};

__device__ inline FaceComponents onFace(uint face, Caps caps) {
  switch (face) {
    case 0: return {caps.x, -caps.z, -caps.y};
    case 1: return {-caps.x, caps.z, -caps.y};
    case 2: return {caps.y, caps.x, caps.z};
    case 3: return {-caps.y, caps.x, -caps.z};
    case 4: return {caps.z, caps.x, -caps.y};
    default: return {-caps.z, -caps.x, -caps.y};
  }
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

// The lane's row of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
struct Rows {
  float atCenter, lengthSquared, alongS, rim;
};

__device__ inline Rows rowsAt(FaceComponents components, float t, float rim) {
  const Rows rows = {components.major + t * components.alongT, 1.0f + t * t, components.alongS, rim};
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

// 1 / sqrt(x) to some five digits: an estimate from the exponent and two steps of Newton's method. It
// decides no bit.
__device__ inline float inverseRoot(float x) {
  float inverse = __uint_as_float(0x5f3759dfu - (__float_as_uint(x) >> 1));
  for (int step = 0; step < 2; ++step)
    inverse = inverse * (1.5f - 0.5f * x * inverse * inverse);
  return inverse;
}

// The ends from the roots of (c.D)^2 = |c|^2 rim, a quadratic in s. Rounding may put them into a
// wrong column, so they count only where the test itself agrees on both sides of them. Where products
// could leave float32, or the cap holds the face's s axis, ends are found by bisection.
__device__ inline uint endsOfRow(Rows rows) {
  const float leading = rows.rim - rows.alongS * rows.alongS;
  if (!(leading > 1e-10f && rows.rim < 1e15f)) return rowBitsByBisection(rows);
  const float inverseOfRoot = inverseRoot(leading);
  const float scale = 16.0f * inverseOfRoot * inverseOfRoot;  // columns per s, over leading
  const float discriminant =
      rows.rim * (rows.atCenter * rows.atCenter - rows.lengthSquared * leading);
  const float positive = fmaxf(discriminant, 1e-30f);
  const float reach = positive * inverseRoot(positive) * scale;
  const float middle = 15.5f + (rows.atCenter * rows.alongS) * scale;
  const float low = -1.0f, high = float(FACE_SIZE);
  const float begin = fminf(fmaxf(middle - reach, low), high),
              end = fminf(fmaxf(middle + reach, low), high);
  const int first = max(int(ceilf(begin)), 0), last = min(int(floorf(end)), FACE_SIZE - 1);
  const bool atFirst = isBlocked(rows, min(first, FACE_SIZE - 1)),
             atLast = isBlocked(rows, max(last, 0)),
             before = first > 0 && isBlocked(rows, first - 1),
             after = last < FACE_SIZE - 1 && isBlocked(rows, last + 1);
  const bool empty = first > last;
  const bool wrong = empty ? atFirst || atLast : !(atFirst && atLast && !before && !after);
  if (wrong) return rowBitsByBisection(rows);
  return empty ? 0u : columnBits(first, last);
}

__device__ inline uint rowBits(Rows rows) {
  return mayBeBlocked(rows) ? endsOfRow(rows) : 0;
}

// Caps and the faces they reach.
#define CAP_FLOATS (5 * LANES)

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
        if (faces >> face & 1)
          rows[face * FACE_SIZE + LANE] |=
              rowBits(rowsAt(onFace(face, caps), centerCoordinate(int(LANE)), caps.rim));
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
