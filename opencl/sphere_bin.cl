// Which entry of the sphere table a sphere falls into. Twin of src/visibility/sphere_bin.cpp: the
// same operations in the same order, since they decide bits. Every element of a vector has a sphere
// and a sample of its own.

// Steps of a search by halves, unrolled.
#define FOR_EACH_STEP(SEARCH) SEARCH(16.0f) SEARCH(8.0f) SEARCH(4.0f) SEARCH(2.0f) SEARCH(1.0f)

// Largest column (or row) whose lower border (column - 16) * major/16 is not above `coordinate`.
inline LaneInt texelOf(LaneFloat coordinate, LaneFloat major) {
  const LaneFloat sixteenth = 0.0625f * major;
  LaneFloat place = -16.0f;
#define SEARCH_TEXEL(step)                                                  \
  {                                                                         \
    const LaneFloat next = place + step;                                    \
    place = select(place, next, (LaneInt)(coordinate >= next * sixteenth)); \
  }
  FOR_EACH_STEP(SEARCH_TEXEL)
#undef SEARCH_TEXEL
  return TO_LANE_INT(place) + 16;
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
inline LaneInt radiusBin(LaneFloat x, LaneFloat y, LaneFloat z, LaneFloat radius,
                         LaneFloat height) {
  const LaneFloat distanceSquared = (x * x + y * y) + z * z;
  const LaneFloat radiusSquared = radius * radius;
  const LaneFloat depth = fmin(height, (LaneFloat)0.0f);
  const LaneFloat limit = (float)HORIZON_FACTOR * depth * depth;
  const LaneFloat reach = fmin(radiusSquared, distanceSquared - limit);
  const LaneFloat unit = 0x1p-15f * distanceSquared;
  LaneFloat bin = 0.0f;
#define SEARCH_BIN(step)                                                   \
  {                                                                        \
    const LaneFloat next = bin + step;                                     \
    bin = select(bin, next, (LaneInt)(next * next * next * unit <= reach)); \
  }
  FOR_EACH_STEP(SEARCH_BIN)
#undef SEARCH_BIN
  return TO_LANE_INT(bin);
}

inline LaneUint tableEntry(SeenSpheres seen) {
  return TO_LANE_UINT(directionBin(seen.x, seen.y, seen.z) * RADIUS_BINS +
                      radiusBin(seen.x, seen.y, seen.z, seen.radius, seen.height));
}
