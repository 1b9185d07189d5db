// Spheres follow the vertices of a mesh (src/visibility/sphere_binding.h, with the formulas). What is
// called a sample elsewhere is a sphere here; lane j adds entries j, j + 32, … of its list.

// Twin of squareRoot() in src/visibility/sphere_binding.cpp.
__device__ inline float squareRoot(float x) {
  float inverse = __uint_as_float(0x5f3759dfu - (__float_as_uint(x) >> 1));
  const float halved = 0.5f * x;
  for (int step = 0; step < 3; ++step)
    inverse = inverse * __fmaf_rn(-(halved * inverse), inverse, 1.5f);
  const float root = x * inverse;
  return __fmaf_rn(__fmaf_rn(-root, root, x), 0.5f * inverse, root);
}

HAARLIGHT_KERNEL void moveSpheres(const float4* __restrict__ positions,
                                  const uint sphereCount,
                                  const uint* __restrict__ listStarts,
                                  const uint* __restrict__ vertices,
                                  const float4* __restrict__ weights,
                                  const float2* __restrict__ radiusFactors,
                                  float4* __restrict__ spheres) {
  SAMPLE_LOCAL(float, xPartials, LANES);
  SAMPLE_LOCAL(float, yPartials, LANES);
  SAMPLE_LOCAL(float, zPartials, LANES);
  SAMPLE_LOCAL(float, meanPartials, LANES);
  SAMPLE_LOCAL(float, reachPartials, LANES);
  // Blocks are full: threads beyond the last sphere do its work again.
  const uint sphere = min(uint(SAMPLE), sphereCount - 1);
  const uint begin = listStarts[sphere], end = listStarts[sphere + 1];
  const float4 origin = positions[vertices[begin]];

  float x = 0.0f, y = 0.0f, z = 0.0f;
  for (uint k = begin + LANE; k < end; k += LANES) {
    const float4 vertex = positions[vertices[k]];
    x = __fmaf_rn(weights[k].x, vertex.x - origin.x, x);
    y = __fmaf_rn(weights[k].x, vertex.y - origin.y, y);
    z = __fmaf_rn(weights[k].x, vertex.z - origin.z, z);
  }
  xPartials[LANE] = x;
  yPartials[LANE] = y;
  zPartials[LANE] = z;
  LANE_BARRIER();
  const float centerX = origin.x + addPartials(xPartials),
              centerY = origin.y + addPartials(yPartials),
              centerZ = origin.z + addPartials(zPartials);

  float ownMean = 0.0f, ownReach = 0.0f;
  for (uint k = begin + LANE; k < end; k += LANES) {
    const float4 vertex = positions[vertices[k]];
    const float dx = vertex.x - centerX, dy = vertex.y - centerY, dz = vertex.z - centerZ;
    const float squared = __fmaf_rn(dz, dz, __fmaf_rn(dy, dy, dx * dx));
    ownMean = __fmaf_rn(weights[k].y, squared, ownMean);
    ownReach = fmaxf(ownReach, weights[k].z * squared);
  }
  meanPartials[LANE] = ownMean;
  reachPartials[LANE] = ownReach;
  LANE_BARRIER();
  const float mean = addPartials(meanPartials), reach = largestPartial(reachPartials);
  const float2 factors = radiusFactors[sphere];
  if (LANE == 0)
    spheres[SAMPLE] = make_float4(centerX, centerY, centerZ,
                                  squareRoot(__fmaf_rn(factors.y, reach, factors.x * mean)));
}
