// Step 1 without the table: the union of all spheres' exact visibility cubes, per sample. Twin of
// src/visibility/exact_visibility.cpp: the same operations in the same order, since they decide
// bits.
//
// Lane j keeps row j of each of the six faces. Spheres are taken 32 at a time: each lane prepares
// one of them, then all lanes test their rows against all 32. A group of fewer than 32 is filled up
// with the last sphere, which changes nothing in a union.

// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
// so that no texel is lost.
#define CAUTION 1.00001f

// Components along a face's direction and its s and t axes.
inline float4 onFace(uint face, float4 d) {
  switch (face) {
    case 0: return (float4)(d.x, -d.z, -d.y, 0.0f);
    case 1: return (float4)(-d.x, d.z, -d.y, 0.0f);
    case 2: return (float4)(d.y, d.x, d.z, 0.0f);
    case 3: return (float4)(-d.y, d.x, -d.z, 0.0f);
    case 4: return (float4)(d.z, d.x, -d.y, 0.0f);
    default: return (float4)(-d.z, -d.x, -d.y, 0.0f);
  }
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

// Room for the spheres of a group as seen from the sample: vector to the centre, d^2 cos^2 alpha, and
// the faces reached.
#define CAP_FLOATS (4 * LANES)

inline void findCaps(__global const float4* restrict spheres, uint sphereCount, uint first,
                     float4 position, float4 normal, __local float* caps, __local uint* faces) {
  FOR_EACH_LANE(lane) {
    const float4 sphere = spheres[min(first + lane, sphereCount - 1)];
    caps[lane] = sphere.x - position.x;
    caps[lane + LANES] = sphere.y - position.y;
    caps[lane + 2 * LANES] = sphere.z - position.z;
    caps[lane + 3 * LANES] = sphere.w;
  }
  for (uint vector = 0; vector < LANE_VECTORS; ++vector) {
    __local float* own = caps + 16 * vector;
    const LaneFloat x = LOAD_LANES(own), y = LOAD_LANES(own + LANES),
                    z = LOAD_LANES(own + 2 * LANES), radius = LOAD_LANES(own + 3 * LANES);
    const LaneFloat distanceSquared = (x * x + y * y) + z * z;
    const LaneFloat radiusSquared = radius * radius;
    const LaneFloat height = (x * normal.x + y * normal.y) + z * normal.z;
    const LaneFloat depth = fmin(height, (LaneFloat)0.0f);
    const LaneFloat limit = (float)HORIZON_FACTOR * depth * depth;
    const LaneFloat rim = fmax(fmax(distanceSquared - radiusSquared, (LaneFloat)0.0f), limit);
    STORE_LANES(rim, own + 3 * LANES);
    STORE_LANES(TO_LANE_UINT(reachedFaces(x, y, z, rim)), faces + 16 * vector);
  }
}

// One row of a face per lane: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
typedef struct {
  LaneFloat atCenter, lengthSquared;
  float alongS, rim;
} Rows;

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
  const LaneInt end = rows.alongS > 0.0f ? FACE_SIZE - 1 : 0;
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
inline LaneUint rowBits(Rows rows) {
  const float leading = rows.rim - rows.alongS * rows.alongS;
  if (!(leading > 1e-10f && rows.rim < 1e15f)) return rowBitsByBisection(rows);
  const LaneFloat inverseOfRoot = inverseRoot((LaneFloat)leading);
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
  if (ANY_LANE(wrong)) return rowBitsByBisection(rows);
  return select(columnBits(first, last), (LaneUint)0, empty);
}

HAARLIGHT_KERNEL void mergeBitCubesExactly(__global const float4* restrict positions,
                                           __global const float4* restrict normals,
                                           __global const float4* restrict spheres,
                                           const uint sphereCount,
                                           __global uint* restrict bitCubes) {
  SAMPLE_LOCAL(float, caps, CAP_FLOATS);
  SAMPLE_LOCAL(uint, faces, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];

  LaneUint blocked[FACES][LANE_VECTORS];
  for (uint face = 0; face < FACES; ++face)
    for (uint vector = 0; vector < LANE_VECTORS; ++vector) blocked[face][vector] = 0;

  for (uint first = 0; first < sphereCount; first += LANES) {
    findCaps(spheres, sphereCount, first, position, normal, caps, faces);
    LANE_BARRIER();
    for (uint i = 0; i < min((uint)LANES, sphereCount - first); ++i) {
      const float4 cap = (float4)(caps[i], caps[i + LANES], caps[i + 2 * LANES], 0.0f);
      const float rim = caps[i + 3 * LANES];
      for (uint reached = faces[i]; reached; reached &= reached - 1) {
        const uint face = 31 - clz(reached & -reached);
        const float4 d = onFace(face, cap);
        for (uint vector = 0; vector < LANE_VECTORS; ++vector) {
          const LaneFloat t = centerCoordinate(LANE_NUMBERS(vector));
          const Rows rows = {d.x + t * d.z, 1.0f + t * t, d.y, rim};
          const LaneInt mayBe = mayBeBlocked(rows);
          if (ANY_LANE(mayBe))
            blocked[face][vector] |= select((LaneUint)0, rowBits(rows), mayBe);
        }
      }
    }
    LANE_BARRIER();
  }

  __global uint* ownRows = bitCubes + sample * BIT_CUBE_ROWS;
  for (uint face = 0; face < FACES; ++face)
    for (uint vector = 0; vector < LANE_VECTORS; ++vector)
      STORE_LANES(blocked[face][vector], ownRows + face * FACE_SIZE + 16 * vector);
}
