#pragma once

#include <span>

#include "cube/bit_cube.h"
#include "visibility/sphere.h"

namespace haarlight {

/// Sets the bits of every texel whose centre direction meets the sphere, seen from a sample that
/// lies `toCenter` away from its centre, in double and without the quantisation of the table:
/// blocked iff dir·v ≥ cos α. A sample inside the sphere follows the rule of radiusBin: r' = 1/r.
void addSphereExactly(BitCube& cube, const glm::dvec3& toCenter, double radius);

/// Union over all spheres, seen from `samplePosition`.
BitCube exactBitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition);

}  // namespace haarlight
