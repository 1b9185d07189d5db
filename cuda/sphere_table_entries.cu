// Step 1 on its own: the entry of the sphere table that each sphere falls into, per sample
// (receiver · spheres + sphere). Frames do not need it; verification does.

HAARLIGHT_KERNEL void sphereTableEntries(const float4* __restrict__ positions,
                                         const float4* __restrict__ normals,
                                         const float4* __restrict__ spheres,
                                         const uint sphereCount,
                                         uint* __restrict__ tableEntries) {
  SAMPLE_LOCAL(uint, entries, LANES);
  const size_t sample = SAMPLE;
  const float4 position = positions[sample], normal = normals[sample];

  for (uint first = 0; first < sphereCount; first += LANES) {
    findTableEntries(spheres, sphereCount, first, position, normal, entries);
    if (first + LANE < sphereCount)
      tableEntries[sample * sphereCount + first + LANE] = entries[LANE];
  }
}
