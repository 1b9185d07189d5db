// Which entry of the sphere table a sphere falls into. Twin of src/visibility/sphere_bin.cpp: the
// same operations in the same order, since they decide bits. A lane has a sphere of its own.

// Largest column (or row) whose lower border (column - 16)/16 * major is not above `coordinate`.
inline LaneInt texelOf(LaneFloat coordinate, LaneFloat major) {
  LaneInt column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const LaneFloat border = TO_LANE_FLOAT(column + step - 16) * 0.0625f * major;
    column = select(column, column + step, coordinate >= border);
  }
  return column;
}

inline LaneInt directionBin(LaneFloat x, LaneFloat y, LaneFloat z) {
  const LaneFloat absX = fabs(x), absY = fabs(y), absZ = fabs(z);
  const LaneInt alongX = (absX >= absY) & (absX >= absZ), alongY = absY >= absZ;
  const LaneFloat along = select(select(z, y, alongY), x, alongX);
  const LaneInt positive = along > 0.0f;
  const LaneFloat s = select(select(select(-x, x, positive), x, alongY),
                             select(z, -z, positive), alongX);
  const LaneFloat t = select(select(-y, select(-z, z, positive), alongY), -y, alongX);
  const LaneInt axis = select(select((LaneInt)4, (LaneInt)2, alongY), (LaneInt)0, alongX);
  const LaneInt face = axis + select((LaneInt)1, (LaneInt)0, positive);
  const LaneFloat major = fabs(along);
  return (face * FACE_SIZE + texelOf(t, major)) * FACE_SIZE + texelOf(s, major);
}

// r^2 >= (bin/32)^3 without the quotient; less where the centre is below the tangent plane.
inline LaneInt radiusBin(LaneFloat x, LaneFloat y, LaneFloat z, LaneFloat radius, float4 normal) {
  const LaneFloat distanceSquared = (x * x + y * y) + z * z;
  const LaneFloat radiusSquared = radius * radius;
  const LaneFloat height = (x * normal.x + y * normal.y) + z * normal.z;
  const LaneFloat depth = fmin(height, (LaneFloat)0.0f);
  const LaneFloat limit = (float)HORIZON_FACTOR * depth * depth;
  LaneInt bin = 0;
  for (int step = 16; step > 0; step /= 2) {
    const LaneInt next = bin + step;
    const LaneFloat bound = TO_LANE_FLOAT(next * next * next) * 0x1p-15f;
    bin = select(bin, next, (radiusSquared >= bound * distanceSquared) &
                                (limit <= (1.0f - bound) * distanceSquared));
  }
  return bin;
}

// Table entries of the spheres first, first + 1, …, one per lane; the last sphere fills up the lanes
// beyond sphereCount. `seen` is room for the spheres as seen from the sample, 4 · LANES floats.
inline void findTableEntries(__global const float4* restrict spheres, uint sphereCount, uint first,
                             float4 position, float4 normal, __local float* seen,
                             __local uint* entries) {
  FOR_EACH_LANE(lane) {
    const float4 sphere = spheres[min(first + lane, sphereCount - 1)];
    seen[lane] = sphere.x - position.x;
    seen[lane + LANES] = sphere.y - position.y;
    seen[lane + 2 * LANES] = sphere.z - position.z;
    seen[lane + 3 * LANES] = sphere.w;
  }
  for (uint vector = 0; vector < LANE_VECTORS; ++vector) {
    __local const float* own = seen + 16 * vector;
    const LaneFloat x = LOAD_LANES(own), y = LOAD_LANES(own + LANES),
                    z = LOAD_LANES(own + 2 * LANES), radius = LOAD_LANES(own + 3 * LANES);
    const LaneInt entry = directionBin(x, y, z) * RADIUS_BINS + radiusBin(x, y, z, radius, normal);
    STORE_LANES(TO_LANE_UINT(entry), entries + 16 * vector);
  }
}
