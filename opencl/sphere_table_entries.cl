// Step 1 on its own: the entry of the sphere table that each sphere falls into, per sample
// (receiver · spheres + sphere). Frames do not need it; verification does.

HAARLIGHT_KERNEL void sphereTableEntries(__global const float4* restrict positions,
                                         __global const float4* restrict normals,
                                         __global const float* restrict spheres,
                                         const uint sphereCount,
                                         __global uint* restrict tableEntries) {
  const Tile tile = loadTile(positions, normals);
  const uint stride = sphereStride(sphereCount);
#if LANES_PER_ITEM == 1
  for (uint first = 0; first < sphereCount; first += LANES) {
    const uint entry = tableEntry(seeSpheres(&tile, spheres, stride, first));
    if (first + FIRST_LANE < sphereCount)
      tableEntries[FIRST_OF_TILE * sphereCount + first + FIRST_LANE] = entry;
  }
#else
  SAMPLE_LOCAL(uint, entries, TILE);
  for (uint sphere = 0; sphere < sphereCount; ++sphere) {
    STORE_LANES(tableEntry(seeSphere(&tile, spheres, stride, sphere)), entries);
    for (uint sample = 0; sample < TILE; ++sample)
      tableEntries[(FIRST_OF_TILE + sample) * sphereCount + sphere] = entries[sample];
  }
#endif
}
