#pragma once

/// The bit cube of a sphere without the table's quantisation: a texel is blocked iff the ray
/// through its centre meets the sphere, dir·v ≥ cos α.
///
/// This file decides bits, so it follows the numeric contract (docs/numerics.md): float32
/// additions, multiplications and comparisons only, in the order written here. With the texel's
/// direction c = (±1, s, t) not normalised, D the vector to the centre and d² its square, the test
/// is
///
///     c·D ≥ 0  and  (c·D)² ≥ |c|² · d² cos²α,    d² cos²α = max(d² − R², 0, 16 min(0, D·n)²);
///
/// the last two terms are the rule for spheres that contain the sample or lie below its tangent
/// plane (horizonFactor in visibility/sphere_bin.h). |c|² = 1 + s² + t² is exact.
///
/// Along a row a cap's texels form one interval around the place s = S (1 + t²) / A where c·D/|c|
/// is largest (c·D = A + s S), so its ends are found by bisection with the test itself. Its twins
/// are merge_bit_cubes_exactly.cl in opencl/ and .cu in cuda/.

#include <span>

#include "cube/bit_cube.h"
#include "visibility/sphere.h"

namespace haarlight {

/// Sets the bits that a sphere blocks, seen from a sample with unit `normal`.
void addSphereExactly(BitCube& cube, const Sphere& sphere, const glm::vec3& samplePosition,
                      const glm::vec3& sampleNormal);

/// Union over all spheres.
BitCube exactBitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition,
                     const glm::vec3& sampleNormal);

}  // namespace haarlight
