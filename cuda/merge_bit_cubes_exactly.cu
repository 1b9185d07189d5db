// Step 1 without the table: the union of all spheres' exact visibility cubes, per sample. Twin of
// src/visibility/exact_visibility.cpp: the same operations in the same order, since they decide
// bits.
//
// Lane j keeps row j of each of the six faces. Spheres are taken 32 at a time: each lane prepares
// one of them, then all lanes test their rows against all 32.

// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
// so that no texel is lost.
#define CAUTION 1.00001f

// Components along a face's direction and its s and t axes.
__device__ inline float4 onFace(uint face, float4 d) {
  switch (face) {
    case 0: return make_float4(d.x, -d.z, -d.y, 0.0f);
    case 1: return make_float4(-d.x, d.z, -d.y, 0.0f);
    case 2: return make_float4(d.y, d.x, d.z, 0.0f);
    case 3: return make_float4(-d.y, d.x, -d.z, 0.0f);
    case 4: return make_float4(d.z, d.x, -d.y, 0.0f);
    default: return make_float4(-d.z, -d.x, -d.y, 0.0f);
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

// Room for the spheres of a group as seen from the sample: vector to the centre, d^2 cos^2 alpha, and
// the faces reached.
#define CAP_FLOATS (4 * LANES)

__device__ inline void findCaps(const float4* __restrict__ spheres, uint sphereCount, uint first,
                                float4 position, float4 normal, float* caps, uint* faces) {
  const float4 sphere = spheres[min(first + LANE, sphereCount - 1)];
  const float x = sphere.x - position.x, y = sphere.y - position.y, z = sphere.z - position.z;
  const float distanceSquared = (x * x + y * y) + z * z;
  const float radiusSquared = sphere.w * sphere.w;
  const float height = (x * normal.x + y * normal.y) + z * normal.z;
  const float depth = fminf(height, 0.0f);
  const float limit = float(HORIZON_FACTOR) * depth * depth;
  const float rim = fmaxf(fmaxf(distanceSquared - radiusSquared, 0.0f), limit);
  caps[LANE] = x;
  caps[LANE + LANES] = y;
  caps[LANE + 2 * LANES] = z;
  caps[LANE + 3 * LANES] = rim;
  faces[LANE] = reachedFaces(x, y, z, rim);
}

// The lane's row of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
struct Row {
  float atCenter, lengthSquared;
  float alongS, rim;
};

__device__ inline bool isBlocked(Row row, int column) {
  const float s = centerCoordinate(column);
  const float dotProduct = row.atCenter + s * row.alongS;
  return dotProduct >= 0.0f && dotProduct * dotProduct >= (row.lengthSquared + s * s) * row.rim;
}

// By Cauchy's inequality (c.D)^2 <= (atCenter^2 / lengthSquared + alongS^2) |c|^2.
__device__ inline bool mayBeBlocked(Row row) {
  const float ahead = fmaxf(row.atCenter, 0.0f);
  const float bound = ahead * ahead + row.alongS * row.alongS * row.lengthSquared;
  return bound * CAUTION >= row.lengthSquared * row.rim;
}

// Column of the place where the angle to the sphere's centre is least.
__device__ inline int nearestColumn(Row row) {
  const float place = row.alongS * row.lengthSquared;
  int column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const float border = float(column + step - 16) * 0.0625f * row.atCenter;
    column = place >= border ? column + step : column;
  }
  const int end = row.alongS > 0.0f ? FACE_SIZE - 1 : 0;
  return row.atCenter > 0.0f ? column : end;
}

// A blocked column, if there is one; else any.
__device__ inline int blockedColumn(Row row) {
  const int nearest = nearestColumn(row);
  const int left = max(nearest - 1, 0), right = min(nearest + 1, FACE_SIZE - 1);
  return isBlocked(row, nearest) ? nearest : isBlocked(row, left) ? left : right;
}

__device__ inline uint columnBits(int first, int last) {
  return (~0u << first) & (~0u >> (FACE_SIZE - 1 - last));
}

// The ends of the interval by bisection with the test itself.
__device__ inline uint rowBitsByBisection(Row row) {
  const int inside = blockedColumn(row);
  int first = inside, last = inside;
  for (int step = 16; step > 0; step /= 2) {
    first = first >= step && isBlocked(row, first - step) ? first - step : first;
    last = last + step < FACE_SIZE && isBlocked(row, last + step) ? last + step : last;
  }
  return isBlocked(row, inside) ? columnBits(first, last) : 0u;
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
__device__ inline uint rowBits(Row row) {
  const float leading = row.rim - row.alongS * row.alongS;
  if (!(leading > 1e-10f && row.rim < 1e15f)) return rowBitsByBisection(row);
  const float inverseOfRoot = inverseRoot(leading);
  const float scale = 16.0f * inverseOfRoot * inverseOfRoot;  // columns per s, over leading
  const float discriminant =
      row.rim * (row.atCenter * row.atCenter - row.lengthSquared * leading);
  const float positive = fmaxf(discriminant, 1e-30f);
  const float reach = positive * inverseRoot(positive) * scale;
  const float middle = 15.5f + (row.atCenter * row.alongS) * scale;
  const float low = -1.0f, high = float(FACE_SIZE);
  const float begin = fminf(fmaxf(middle - reach, low), high),
              end = fminf(fmaxf(middle + reach, low), high);
  const int first = max(int(ceilf(begin)), 0), last = min(int(floorf(end)), FACE_SIZE - 1);
  const bool atFirst = isBlocked(row, min(first, FACE_SIZE - 1)),
             atLast = isBlocked(row, max(last, 0)),
             before = first > 0 && isBlocked(row, first - 1),
             after = last < FACE_SIZE - 1 && isBlocked(row, last + 1);
  const bool empty = first > last;
  const bool wrong = empty ? atFirst || atLast : !(atFirst && atLast && !before && !after);
  if (wrong) return rowBitsByBisection(row);
  return empty ? 0u : columnBits(first, last);
}

HAARLIGHT_KERNEL void mergeBitCubesExactly(const float4* __restrict__ positions,
                                           const float4* __restrict__ normals,
                                           const float4* __restrict__ spheres,
                                           const uint sphereCount,
                                           uint* __restrict__ bitCubes) {
  SAMPLE_LOCAL(float, caps, CAP_FLOATS);
  SAMPLE_LOCAL(uint, faces, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];

  uint blocked[FACES];
  for (uint face = 0; face < FACES; ++face) blocked[face] = 0;

  for (uint first = 0; first < sphereCount; first += LANES) {
    findCaps(spheres, sphereCount, first, position, normal, caps, faces);
    LANE_BARRIER();
    for (uint i = 0; i < min(uint(LANES), sphereCount - first); ++i) {
      const float4 cap = make_float4(caps[i], caps[i + LANES], caps[i + 2 * LANES], 0.0f);
      const float rim = caps[i + 3 * LANES];
      for (uint face = 0; face < FACES; ++face) {
        if ((faces[i] >> face & 1) == 0) continue;
        const float4 d = onFace(face, cap);
        const float t = centerCoordinate(int(LANE));
        const Row row = {d.x + t * d.z, 1.0f + t * t, d.y, rim};
        if (mayBeBlocked(row)) blocked[face] |= rowBits(row);
      }
    }
    LANE_BARRIER();
  }

  uint* ownRows = bitCubes + sample * BIT_CUBE_ROWS;
  for (uint face = 0; face < FACES; ++face) ownRows[face * FACE_SIZE + LANE] = blocked[face];
}
