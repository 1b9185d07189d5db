// Spheres as receivers see them. The numbers of all spheres lie one after the other: all x, all y, all
// z, all radii, each padded to a multiple of 32 with those of the last sphere.

// Vector to the centre, radius, and the centre's height above the tangent plane.
typedef struct {
  LaneFloat x, y, z, radius, height;
} SeenSpheres;

inline uint sphereStride(uint sphereCount) {
  return (sphereCount + LANES - 1) / LANES * LANES;
}

#if LANES_PER_ITEM == 1
// A sample, of which every lane sees another sphere.
typedef struct {
  float4 position, normal;
} Tile;

inline Tile loadTile(__global const float4* positions, __global const float4* normals) {
  const Tile tile = {positions[FIRST_OF_TILE], normals[FIRST_OF_TILE]};
  return tile;
}

inline SeenSpheres seeSpheres(const Tile* tile, __global const float* spheres, uint stride,
                              uint first) {
  __global const float* own = spheres + first + FIRST_LANE;
  const float4 position = tile->position, normal = tile->normal;
  const float x = own[0] - position.x, y = own[stride] - position.y,
              z = own[2 * stride] - position.z;
  const SeenSpheres seen = {x, y, z, own[3 * stride],
                            (x * normal.x + y * normal.y) + z * normal.z};
  return seen;
}
#else
// Samples, which all see the same sphere.
typedef struct {
  LaneFloat x, y, z, normalX, normalY, normalZ;
} Tile;

#define OF_TILE(array, axis)                                                                      \
  (LaneFloat)((array)[0].axis, (array)[1].axis, (array)[2].axis, (array)[3].axis, (array)[4].axis, \
              (array)[5].axis, (array)[6].axis, (array)[7].axis, (array)[8].axis, (array)[9].axis, \
              (array)[10].axis, (array)[11].axis, (array)[12].axis, (array)[13].axis,              \
              (array)[14].axis, (array)[15].axis)

inline Tile loadTile(__global const float4* positions, __global const float4* normals) {
  __global const float4* place = positions + FIRST_OF_TILE;
  __global const float4* normal = normals + FIRST_OF_TILE;
  const Tile tile = {OF_TILE(place, x),  OF_TILE(place, y),  OF_TILE(place, z),
                     OF_TILE(normal, x), OF_TILE(normal, y), OF_TILE(normal, z)};
  return tile;
}

inline SeenSpheres seeSphere(const Tile* tile, __global const float* spheres, uint stride,
                             uint number) {
  const LaneFloat x = spheres[number] - tile->x, y = spheres[number + stride] - tile->y,
                  z = spheres[number + 2 * stride] - tile->z;
  const SeenSpheres seen = {x, y, z, spheres[number + 3 * stride],
                            (x * tile->normalX + y * tile->normalY) + z * tile->normalZ};
  return seen;
}
#endif
