#pragma once

/// Cosine lobes of diffuse reflection, tabulated by normal (method.md §1–2).

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "haar/transform.h"

namespace haarlight {

/// ρ̃ of a white Lambertian surface at every texel: max(0, n·∫ω dω) / π over the texel, times 1024,
/// so that radiance is the sum over faces of a triple product on the unit square. `normal` has
/// length 1. On a texel that the horizon cuts, the maximum is taken of the texel's mean.
std::vector<double> cosineLobe(const glm::dvec3& normal);

/// Cells per side of a face of the grid of tabulated normals. The paper has 8 × 8 normals a face
/// and takes the nearest; blending leaves an error near the horizon only, which falls with the
/// square of the cell: at most 1.1 % of a white furnace with 8 cells, 0.4 % with 16.
inline constexpr int lobeGridCells = 16;
inline constexpr int lobeGridNodes = lobeGridCells + 1;
inline constexpr int lobeCount = faceCount * lobeGridNodes * lobeGridNodes;

/// Unit normal of a tabulated lobe; index = (face · 17 + row) · 17 + column.
glm::dvec3 lobeNormal(int lobe);

/// A normal as a blend of up to three tabulated lobes, Σ weight · lobe, the heaviest first; unused
/// ones weigh 0. The fourth entries are unused (16-byte alignment for kernels).
struct LobeBlend {
  std::uint32_t lobes[4];
  float weights[4];
};
static_assert(sizeof(LobeBlend) == 32);

/// The three lobes at the corners of the grid triangle that holds `normal` (unit length), weighed
/// so that Σ weight · lobeNormal = normal. Where none of the three is cut by the horizon the blend
/// is therefore exact, and grid normals such as ±X ±Y ±Z are exact everywhere.
LobeBlend blendLobes(const glm::vec3& normal);

/// Complete Haar form of a tabulated lobe, in single precision (33 KB).
HaarCube<float> lobeHaar(int lobe);

}  // namespace haarlight
