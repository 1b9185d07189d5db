// Step 1 on its own: the entry of the sphere table that each sphere falls into, per sample
// (receiver · spheres + sphere). Frames do not need it; verification does.

HAARLIGHT_KERNEL void sphereTableEntries(__global const float4* restrict positions,
                                         __global const float4* restrict normals,
                                         __global const float4* restrict spheres,
                                         const uint sphereCount,
                                         __global uint* restrict tableEntries) {
  SAMPLE_LOCAL(float, seen, 4 * LANES);
  SAMPLE_LOCAL(uint, entries, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];

  for (uint first = 0; first < sphereCount; first += LANES) {
    findTableEntries(spheres, sphereCount, first, position, normal, seen, entries);
    FOR_EACH_LANE(lane)
      if (first + lane < sphereCount)
        tableEntries[sample * sphereCount + first + lane] = entries[lane];
  }
}
