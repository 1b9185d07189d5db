// Step 1 on its own: the entry of the sphere table that each sphere falls into, per sample
// (receiver · spheres + sphere). Frames do not need it; verification does.

HAARLIGHT_KERNEL void sphereTableEntries(const float4* __restrict__ positions,
                                         const float4* __restrict__ normals,
                                         const float* __restrict__ spheres,
                                         const uint sphereCount,
                                         uint* __restrict__ tableEntries) {
  const Tile tile = loadTile(positions, normals);
  const uint stride = sphereStride(sphereCount);
  for (uint first = 0; first < sphereCount; first += LANES) {
    const uint entry = tableEntry(seeSpheres(&tile, spheres, stride, first));
    if (first + LANE < sphereCount)
      tableEntries[FIRST_OF_TILE * sphereCount + first + LANE] = entry;
  }
}
