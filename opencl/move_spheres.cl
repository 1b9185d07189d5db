// Spheres follow the vertices of a mesh (src/visibility/sphere_binding.h, with the formulas). What is
// called a sample elsewhere is a sphere here; lane j adds entries j, j + 32, … of its list.

// Twin of squareRoot() in src/visibility/sphere_binding.cpp.
inline float squareRoot(float x) {
  float inverse = as_float(0x5f3759dfu - (as_uint(x) >> 1));
  const float halved = 0.5f * x;
  for (int step = 0; step < 3; ++step) inverse = inverse * fma(-(halved * inverse), inverse, 1.5f);
  const float root = x * inverse;
  return fma(fma(-root, root, x), 0.5f * inverse, root);
}

HAARLIGHT_KERNEL void moveSpheres(__global const float4* restrict positions,
                                  const uint sphereCount,
                                  __global const uint* restrict listStarts,
                                  __global const uint* restrict vertices,
                                  __global const float4* restrict weights,
                                  __global const float2* restrict radiusFactors,
                                  __global float4* restrict spheres) {
  SAMPLE_LOCAL(float, xPartials, LANES);
  SAMPLE_LOCAL(float, yPartials, LANES);
  SAMPLE_LOCAL(float, zPartials, LANES);
  SAMPLE_LOCAL(float, meanPartials, LANES);
  SAMPLE_LOCAL(float, reachPartials, LANES);
  // Work-groups are full: items beyond the last sphere do its work again.
  const uint sphere = min((uint)SAMPLE, sphereCount - 1);
  const uint begin = listStarts[sphere], end = listStarts[sphere + 1];
  const float4 origin = positions[vertices[begin]];

  FOR_EACH_LANE(lane) {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    for (uint k = begin + lane; k < end; k += LANES) {
      const float4 offset = positions[vertices[k]] - origin;
      x = fma(weights[k].x, offset.x, x);
      y = fma(weights[k].x, offset.y, y);
      z = fma(weights[k].x, offset.z, z);
    }
    xPartials[lane] = x;
    yPartials[lane] = y;
    zPartials[lane] = z;
  }
  LANE_BARRIER();
  const float centerX = origin.x + addPartials(xPartials),
              centerY = origin.y + addPartials(yPartials),
              centerZ = origin.z + addPartials(zPartials);

  FOR_EACH_LANE(lane) {
    float mean = 0.0f, reach = 0.0f;
    for (uint k = begin + lane; k < end; k += LANES) {
      const float4 vertex = positions[vertices[k]];
      const float x = vertex.x - centerX, y = vertex.y - centerY, z = vertex.z - centerZ;
      const float squared = fma(z, z, fma(y, y, x * x));
      mean = fma(weights[k].y, squared, mean);
      reach = fmax(reach, weights[k].z * squared);
    }
    meanPartials[lane] = mean;
    reachPartials[lane] = reach;
  }
  LANE_BARRIER();
  const float mean = addPartials(meanPartials), reach = largestPartial(reachPartials);
  const float2 factors = radiusFactors[sphere];
  if (FIRST_LANE == 0)
    spheres[SAMPLE] = (float4)(centerX, centerY, centerZ,
                               squareRoot(fma(factors.y, reach, factors.x * mean)));
}
