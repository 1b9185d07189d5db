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

// A sphere seen from the sample: vector to its centre and d^2 cos^2 alpha.
inline float4 capOf(float4 sphere, float4 position, float4 normal) {
  const float x = sphere.x - position.x, y = sphere.y - position.y, z = sphere.z - position.z;
  const float distanceSquared = (x * x + y * y) + z * z;
  const float radiusSquared = sphere.w * sphere.w;
  const float height = (x * normal.x + y * normal.y) + z * normal.z;
  const float depth = fmin(height, 0.0f);
  const float limit = (float)HORIZON_FACTOR * depth * depth;
  return (float4)(x, y, z, fmax(fmax(distanceSquared - radiusSquared, 0.0f), limit));
}

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

// Whether the cap reaches neither beyond the face's rows nor beyond its columns (`alongT`, `alongS`
// exchanged). By Cauchy's inequality (c.D)^2 / |c|^2 <= (major + t alongT)^2 / (1 + t^2) + alongS^2,
// which is largest at t = 1 when the sphere's centre is beyond the face's edge.
inline bool isBeyondEdge(float major, float alongT, float alongS, float rim) {
  const float atEdge = fmax(major + fabs(alongT), 0.0f);
  const float bound = 0.5f * (atEdge * atEdge) + alongS * alongS;
  return fabs(alongT) > major && bound * CAUTION < rim;
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

inline LaneUint rowBits(Rows rows) {
  const LaneInt inside = blockedColumn(rows);
  LaneInt first = inside, last = inside;
  for (int step = 16; step > 0; step /= 2) {
    first = select(first, first - step, (first >= step) & isBlocked(rows, first - step));
    last = select(last, last + step, (last + step < FACE_SIZE) & isBlocked(rows, last + step));
  }
  const LaneUint all = ~0u;
  const LaneUint bits = (all << TO_LANE_UINT(first)) & (all >> TO_LANE_UINT(FACE_SIZE - 1 - last));
  return select((LaneUint)0, bits, isBlocked(rows, inside));
}

HAARLIGHT_KERNEL void mergeBitCubesExactly(__global const float4* restrict positions,
                                           __global const float4* restrict normals,
                                           __global const float4* restrict spheres,
                                           const uint sphereCount,
                                           __global uint* restrict bitCubes) {
  SAMPLE_LOCAL(float4, caps, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];

  LaneUint blocked[FACES][LANE_VECTORS];
  for (uint face = 0; face < FACES; ++face)
    for (uint vector = 0; vector < LANE_VECTORS; ++vector) blocked[face][vector] = 0;

  for (uint first = 0; first < sphereCount; first += LANES) {
    FOR_EACH_LANE(lane)
      caps[lane] = capOf(spheres[min(first + lane, sphereCount - 1)], position, normal);
    LANE_BARRIER();
    for (uint i = 0; i < min((uint)LANES, sphereCount - first); ++i) {
      const float rim = caps[i].w;
      for (uint face = 0; face < FACES; ++face) {
        const float4 d = onFace(face, caps[i]);
        if (isBeyondEdge(d.x, d.z, d.y, rim) || isBeyondEdge(d.x, d.y, d.z, rim)) continue;
        for (uint vector = 0; vector < LANE_VECTORS; ++vector) {
          const LaneFloat t = centerCoordinate(LANE_NUMBERS(vector));
          const Rows rows = {d.x + t * d.z, 1.0f + t * t, d.y, rim};
          const LaneInt reached = mayBeBlocked(rows);
          if (ANY_LANE(reached))
            blocked[face][vector] |= select((LaneUint)0, rowBits(rows), reached);
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
