// Which entry of the sphere table a sphere falls into. Twin of src/visibility/sphere_bin.cpp: the
// same operations in the same order, since they decide bits. A lane has a sphere of its own.

// Largest column (or row) whose lower border (column - 16) * major/16 is not above `coordinate`.
__device__ inline int texelOf(float coordinate, float major) {
  const float sixteenth = 0.0625f * major;
  float place = -16.0f;
  for (float step = 16.0f; step >= 1.0f; step *= 0.5f) {
    const float next = place + step;
    place = coordinate >= next * sixteenth ? next : place;
  }
  return int(place) + 16;
}

__device__ inline int directionBin(float x, float y, float z) {
  const float absX = fabsf(x), absY = fabsf(y), absZ = fabsf(z);
  const bool alongX = absX >= absY && absX >= absZ, alongY = absY >= absZ;
  const float along = alongX ? x : alongY ? y : z;
  const bool positive = along > 0.0f;
  const float s = alongX ? (positive ? -z : z) : alongY ? x : (positive ? x : -x);
  const float t = alongX ? -y : alongY ? (positive ? z : -z) : -y;
  const int axis = alongX ? 0 : alongY ? 2 : 4;
  const int face = axis + (positive ? 0 : 1);
  const float major = fabsf(along);
  return (face * FACE_SIZE + texelOf(t, major)) * FACE_SIZE + texelOf(s, major);
}

// r^2 >= (bin/32)^3 without the quotient; less where the centre is below the tangent plane.
__device__ inline int radiusBin(float x, float y, float z, float radius, float height) {
  const float distanceSquared = (x * x + y * y) + z * z;
  const float radiusSquared = radius * radius;
  const float depth = fminf(height, 0.0f);
  const float limit = float(HORIZON_FACTOR) * depth * depth;
  const float reach = fminf(radiusSquared, distanceSquared - limit);
  const float unit = 0x1p-15f * distanceSquared;
  float bin = 0.0f;
  for (float step = 16.0f; step >= 1.0f; step *= 0.5f) {
    const float next = bin + step;
    bin = next * next * next * unit <= reach ? next : bin;
  }
  return int(bin);
}

__device__ inline uint tableEntry(SeenSpheres seen) {
  return uint(directionBin(seen.x, seen.y, seen.z) * RADIUS_BINS +
              radiusBin(seen.x, seen.y, seen.z, seen.radius, seen.height));
}
