// Which entry of the sphere table a sphere falls into. Twin of src/visibility/sphere_bin.cpp: the
// same operations in the same order, since they decide bits. A lane has a sphere of its own.

// Largest column (or row) whose lower border (column - 16)/16 * major is not above `coordinate`.
__device__ inline int texelOf(float coordinate, float major) {
  int column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const float border = float(column + step - 16) * 0.0625f * major;
    column = coordinate >= border ? column + step : column;
  }
  return column;
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
__device__ inline int radiusBin(float x, float y, float z, float radius, float4 normal) {
  const float distanceSquared = (x * x + y * y) + z * z;
  const float radiusSquared = radius * radius;
  const float height = (x * normal.x + y * normal.y) + z * normal.z;
  const float depth = fminf(height, 0.0f);
  const float limit = float(HORIZON_FACTOR) * depth * depth;
  int bin = 0;
  for (int step = 16; step > 0; step /= 2) {
    const int next = bin + step;
    const float bound = float(next * next * next) * 0x1p-15f;
    const bool reaches = radiusSquared >= bound * distanceSquared &&
                         limit <= (1.0f - bound) * distanceSquared;
    bin = reaches ? next : bin;
  }
  return bin;
}

// Table entries of the spheres first, first + 1, …, one per lane; the last sphere fills up the
// lanes beyond sphereCount.
__device__ inline void findTableEntries(const float4* __restrict__ spheres, uint sphereCount,
                                        uint first, float4 position, float4 normal, uint* entries) {
  const float4 sphere = spheres[min(first + LANE, sphereCount - 1)];
  const float x = sphere.x - position.x, y = sphere.y - position.y, z = sphere.z - position.z;
  entries[LANE] =
      uint(directionBin(x, y, z) * RADIUS_BINS + radiusBin(x, y, z, sphere.w, normal));
}
