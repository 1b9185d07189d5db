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
/// (§3.5) with its non-linear cut (§4.1), grouped by the factor that is sparse:
///
///   light terms   the Φ of each face and the N wavelets M of the light that matter most:
///                 L_M (O_M psum(p) + p_M psum(O) + 2^l (p_a O_b + p_b O_a)), a and b the other
///                 types on the square;
///   lobe terms    the wavelets of the lobe: p_M O_M psum(L).
///
/// With all light terms and all lobe terms this is the complete triple product.
///
/// Summation order (method.md §8): terms stand in lists; term k of a list goes by fma into partial
/// sum k mod 32, list after list, and the partial sums are added by the tree 16, 8, 4, 2, 1. The
/// lists: light terms coarse, block, quarter; then for each of the receiver's lobes its lobe terms
/// coarse, block, quarter. "Coarse" is levels 0 … 2, "block" level 3, "quarter" level 4. Every list
/// is filled up with zero terms to a multiple of 32, which changes no sum.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "base/canonical_order.h"
#include "cube/cube_image.h"
#include "material/cosine_lobe.h"

namespace haarlight {

/// Wavelets of all six faces; the Φ of the faces are always kept and not counted.
inline constexpr int waveletCount = faceCount * (coefficientsPerFace - 1);
inline constexpr int maximumTerms = texelCount;

/// Lists of terms by how their occlusion is looked up.
enum TermDetail { coarseTerm = 0, blockTerm = 1, quarterTerm = 2 };
inline constexpr int termDetails = 3;

struct ShadingSettings {
  /// Light wavelets kept, 0 … 6144; from 6138 on everything is kept, of the lobes too.
  int terms = 200;
  /// Levels of occlusion: 1 = the 8×8 face only (GPU-I), 2 = with the 4×4 blocks (GPU-II).
  int levels = 2;
  /// How the light's wavelets are ranked.
  enum class Ranking {
    /// |L| · psum(lobe) · 2^{-1.5 l}: the magnitude weighed by what the lobe makes of the square
    /// and by the root mean square of an occlusion coefficient, 2^{-l} at a shadow edge times the
    /// chance 2^{-l} that an edge crosses the square.
    expectedContribution,
    /// |L| alone, as the paper does.
    magnitude
  } ranking = Ranking::expectedContribution;
};

struct ShadingTables {
  ShadingSettings settings;

  /// Slot of every lobe (lobeCount entries): the lobes that occur among the receivers come one
  /// after the other, all others share the last slot, which is black.
  std::vector<std::uint32_t> lobeSlots;

  /// End of each list in the arrays of light terms.
  std::array<std::uint32_t, termDetails> lightListEnds{};
  /// Where a term's occlusion lies. Coarse: (mean index << 16) | index of the square's first
  /// coefficient, both as in OcclusionHaar; block: block index; quarter: block index · 4 + quarter.
  std::vector<std::uint32_t> lightPlaces;
  /// Light coefficient (RGB, 0).
  std::vector<glm::vec4> lightCoefficients;
  /// slot · terms + term: factors of O_horizontal, O_vertical, O_diagonal and psum(O).
  std::vector<glm::vec4> lightWeights;

  /// Start of each list of lobe terms: slot · 3 + detail; one more entry ends the last.
  std::vector<std::uint32_t> lobeListStarts;
  /// (index into lightMeans << 16) | place. Coarse: coefficient index as in OcclusionHaar; block
  /// and quarter: block index · 16 + slot in the block's table entry.
  std::vector<std::uint32_t> lobePlaces;
  std::vector<float> lobeValues;

  /// psum(L) of every square: face · 341 + mean index (RGB, 0).
  std::vector<glm::vec4> lightMeans;
  /// ∫ L p of every slot (RGB, 0).
  std::vector<glm::vec4> unshadowed;

  std::size_t lightTermCount() const { return lightPlaces.size(); }
};

/// Builds the tables. `lobeImportance` says how often each lobe occurs among the receivers
/// (lobeCount weights, any scale); it decides which light terms matter. A lobe of importance 0 is
/// left black, so no receiver may use it. Throws InputError when terms or levels are out of range.
ShadingTables buildShadingTables(const RadianceCube& light, const ShadingSettings& settings,
                                 std::span<const double> lobeImportance);

/// How often each lobe occurs in `lobes`.
std::vector<double> countLobes(std::span<const LobeBlend> lobes);

}  // namespace haarlight
