#pragma once

/// Which entry of the sphere table a sphere falls into, seen from a sample: the (v, r) bins of
/// method.md §3. This file decides bits, so it follows the numeric contract (docs/numerics.md):
/// float32 additions, multiplications and comparisons only, in the order written here. Its twins
/// are opencl/sphere_bin.cl and cuda/sphere_bin.cu.

#include <cstdint>

#include "cube/cube_map.h"
#include "visibility/sphere.h"

namespace haarlight {

inline constexpr int radiusBins = 32;

/// Lower bound of a radius bin, as r² = (bin/32)³; r = radius/distance is the sine of the sphere's
/// angular radius. The cube makes every bound exact in float32, and spends the bins where masks
/// change fastest: of the spacings measured (docs/method.md), r = (bin/32)^1.5 had the least shadow
/// error.
constexpr float radiusBinBound(int bin) {
  return float(bin * bin * bin) * 0x1p-15f;
}

/// r² that stands for all of a bin: its middle, ((bin + ½)/32)³, exact.
constexpr double radiusBinCenter(int bin) {
  return double(2 * bin + 1) * double(2 * bin + 1) * double(2 * bin + 1) / 262144.0;
}

/// Texel of the direction from a sample to a sphere's centre. Unlike texelAt this is exact in
/// float32: the quotient s = x/|major| is never formed, its bounds are multiplied instead.
int directionBin(const glm::vec3& toCenter);

/// Receivers on the model itself lie inside the spheres fitted to it (r ≥ 1), or just outside. Such
/// a sphere is taken for less than it is: r'² = min(r², 1), and where its centre lies below the
/// sample's tangent plane (v·n < 0), r'² = min(r², 1, 1 − 16 (v·n)²). So a sample inside a sphere
/// sees a hemisphere blocked when the centre is above its horizon, and nothing when it is more than
/// 14.5° below. docs/method.md compares this rule with others by their error.
inline constexpr float horizonFactor = 16;

/// Radius bin of a sphere whose centre is `toCenter` away, seen from a sample with unit `normal`.
int radiusBin(const glm::vec3& toCenter, float radius, const glm::vec3& normal);

/// Index of the sphere's mask in the table: directionBin · 32 + radiusBin.
int sphereTableEntry(const Sphere& sphere, const glm::vec3& samplePosition,
                     const glm::vec3& sampleNormal);

}  // namespace haarlight
