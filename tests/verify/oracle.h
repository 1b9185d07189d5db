#pragma once

/// Answers to small cases straight from the definitions of docs/method.md, texel by texel, without
/// any code of the engines: even the faces of the cube are written down anew.
///
/// Decisions about bits are exact: numbers have so few digits that a comparison is either made in
/// float32 without rounding, or decided by a margin far above float32's rounding. A case whose
/// numbers allow neither throws std::logic_error.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "cube/bit_cube.h"
#include "cube/cube_image.h"
#include "haar/occlusion_transform.h"
#include "material/cosine_lobe.h"
#include "visibility/sphere_binding.h"

namespace haarlight::test {

/// Where the spheres are that follow the vertices: the weighted mean of what each follows, and the
/// root of the weighted mean or largest square of the distances.
std::vector<Sphere> oracleMovedSpheres(const SphereBinding& binding,
                                       std::span<const glm::vec4> vertices);

/// The (v, r) bin of a sphere: texel · 32 + radius bin.
std::uint32_t oracleTableEntry(const Sphere& sphere, const glm::dvec3& position,
                               const glm::dvec3& normal);

/// Texels whose centres' rays meet one of the spheres.
BitCube oracleExactBitCube(std::span<const Sphere> spheres, const glm::dvec3& position,
                           const glm::dvec3& normal);

/// Union of the masks of table entries.
BitCube oracleTableBitCube(std::span<const std::uint32_t> entries);

/// Inner products of the bits with the basis functions, and means over their squares.
OcclusionHaar oracleOcclusion(const BitCube& cube);

/// Σ L V ρ̃ over the texels in double, and without the V.
struct OracleRadiance {
  glm::dvec3 shadowed{0}, unshadowed{0};
};
OracleRadiance oracleRadiance(const RadianceCube& light, const BitCube& cube,
                              const LobeBlend& lobes);

}  // namespace haarlight::test
