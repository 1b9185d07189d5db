// Spheres as receivers see them. The numbers of all spheres lie one after the other: all x, all y, all
// z, all radii, each padded to a multiple of 32 with those of the last sphere.

// Vector to the centre, radius, and the centre's height above the tangent plane.
struct SeenSpheres {
  float x, y, z, radius, height;
};

__device__ inline uint sphereStride(uint sphereCount) {
  return (sphereCount + LANES - 1) / LANES * LANES;
}

// A sample, of which every lane sees another sphere.
struct Tile {
  float4 position, normal;
};

__device__ inline Tile loadTile(const float4* positions, const float4* normals) {
  const Tile tile = {positions[FIRST_OF_TILE], normals[FIRST_OF_TILE]};
  return tile;
}

__device__ inline SeenSpheres seeSpheres(const Tile* tile, const float* spheres, uint stride,
                                         uint first) {
  const float* own = spheres + first + LANE;
  const float4 position = tile->position, normal = tile->normal;
  const float x = own[0] - position.x, y = own[stride] - position.y,
              z = own[2 * stride] - position.z;
  const SeenSpheres seen = {x, y, z, own[3 * stride],
                            (x * normal.x + y * normal.y) + z * normal.z};
  return seen;
}
