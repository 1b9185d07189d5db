#pragma once

/// What the triple product needs of light and lobes, computed once per light on the host and handed
/// to every engine in the same form.
///
/// Radiance of a sample with lobe p and occlusion O = 1 − V under light L is, by linearity,
///
///     B = ∫ L p  −  ∫ L O p,
///
/// the unshadowed radiance, which does not depend on the sample and is tabulated exactly per lobe,
/// less a triple product that vanishes where nothing blocks. The triple product is the paper's
/// (§3.5) with its non-linear cut (§4.1): the light's wavelets that matter most, and the lobe's of
/// levels 0 … 2. With all terms of both it is complete. Its terms are gathered by the squares of
/// the Haar pyramid that they read, as integers (engine/square_weights.h):
///
///     B_p = scale_p · (unshadowed_p − Σ weights_p · numbers of blocked texels)   modulo 2³²
///
/// A receiver's radiance is the blend Σ w_i B_i of its lobes, the first by multiplication, the
/// others by fma.

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "base/canonical_order.h"
#include "cube/cube_image.h"
#include "engine/shading_settings.h"
#include "engine/square_weights.h"
#include "material/cosine_lobe.h"

namespace haarlight {

struct ShadingTables {
  ShadingSettings settings;

  /// Slot of every lobe (lobeCount entries): the lobes that occur among the receivers come one
  /// after the other, all others share the last slot, which is black.
  std::vector<std::uint32_t> lobeSlots;

  /// End of each list of squares; coarse squares lie in the order of OcclusionHaar::means.
  std::array<std::uint32_t, squareDetails> squareListEnds{};
  /// Where the occlusion of a square lies. Block squares: block index as in OcclusionHaar; quarter
  /// squares: block index · 4 + quarter; unused for coarse squares.
  std::vector<std::uint32_t> squarePlaces;
  /// Index of a block's square and of its four quarters' in the list, block · 5 + 0 … 4;
  /// absentSquare where the list has none.
  std::vector<std::uint32_t> blockSquares;

  /// slot · squares + square.
  SquareWeights weights;
  /// By slot.
  std::vector<glm::uvec4> unshadowed;
  std::vector<glm::vec4> scales;

  static constexpr std::uint32_t absentSquare = 0x7fffffff;

  std::size_t squareCount() const { return squarePlaces.size(); }
  std::size_t slotCount() const { return unshadowed.size(); }
  /// Radiance of a slot's lobe of which no light is blocked (RGB).
  glm::vec3 unshadowedRadiance(std::size_t slot) const;
};

/// Builds the tables. `lobeImportance` says how often each lobe occurs among the receivers
/// (lobeCount weights, any scale); it decides which light terms matter. A lobe of importance 0 is
/// left black, so no receiver may use it. Throws InputError when terms or levels are out of range.
ShadingTables buildShadingTables(const RadianceCube& light, const ShadingSettings& settings,
                                 std::span<const double> lobeImportance);

/// How often each lobe occurs in `lobes`.
std::vector<double> countLobes(std::span<const LobeBlend> lobes);

}  // namespace haarlight
