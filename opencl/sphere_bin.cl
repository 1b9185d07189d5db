// Which entry of the sphere table a sphere falls into. Twin of src/visibility/sphere_bin.cpp: the
// same operations in the same order, since they decide bits.

// Largest column (or row) whose lower border (column - 16)/16 * major is not above `coordinate`.
inline uint texelOf(float coordinate, float major) {
  int column = 0;
  for (int step = 16; step > 0; step /= 2)
    if (coordinate >= (float)(column + step - 16) * 0.0625f * major) column += step;
  return (uint)column;
}

inline uint directionBin(float x, float y, float z) {
  const float absX = fabs(x), absY = fabs(y), absZ = fabs(z);
  const bool alongX = absX >= absY && absX >= absZ;
  const bool alongY = !alongX && absY >= absZ;
  const float major = alongX ? absX : alongY ? absY : absZ;
  const bool positive = (alongX ? x : alongY ? y : z) > 0;
  const float s = alongX ? (positive ? -z : z) : alongY ? x : (positive ? x : -x);
  const float t = alongY ? (positive ? z : -z) : -y;
  const uint face = (alongX ? 0u : alongY ? 2u : 4u) + (positive ? 0u : 1u);
  return (face * FACE_SIZE + texelOf(t, major)) * FACE_SIZE + texelOf(s, major);
}

// r^2 >= (bin/32)^3 without the quotient; less where the centre is below the tangent plane.
inline uint radiusBin(float x, float y, float z, float radius, float4 normal) {
  const float distanceSquared = (x * x + y * y) + z * z;
  const float radiusSquared = radius * radius;
  const float height = (x * normal.x + y * normal.y) + z * normal.z;
  const float depth = fmin(height, 0.0f);
  const float limit = (float)HORIZON_FACTOR * depth * depth;
  int bin = 0;
  for (int step = 16; step > 0; step /= 2) {
    const int next = bin + step;
    const float bound = (float)(next * next * next) * 0x1p-15f;
    if (radiusSquared >= bound * distanceSquared && limit <= (1.0f - bound) * distanceSquared)
      bin = next;
  }
  return (uint)bin;
}

inline uint sphereTableEntry(float4 sphere, float4 position, float4 normal) {
  const float x = sphere.x - position.x, y = sphere.y - position.y, z = sphere.z - position.z;
  return directionBin(x, y, z) * RADIUS_BINS + radiusBin(x, y, z, sphere.w, normal);
}
