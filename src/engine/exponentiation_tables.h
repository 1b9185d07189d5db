#pragma once

/// What shading by spherical-harmonic exponentiation needs of light and lobes, computed once per
/// light on the host and handed to every engine in the same form.
///
/// With visibility V as coefficients (shexp/exponentiation.h), radiance of a sample with lobe p
/// under light L is
///
///     B = Σ_k V_k ∫ L p y_k dω
///
/// The integrals are tabulated by normal, for the lobes that `haar` has (material/cosine_lobe.h),
/// as Ren et al. do with a cube map of light times cosine. So L and p are not cut off before they
/// are multiplied, as a product of their truncated vectors would: only V is of low frequency, and
/// without spheres B is the exact sum over texels, as by every other method. And no basis function
/// of a normal is evaluated on the device.
///
/// A receiver's integrals are the blend of its lobes', the first by multiplication, the others by
/// fma. Coefficient k goes into partial sum k mod 32, by fma, rows to their padded end; the partial
/// sums are added as a tree (base/canonical_order.h). What is not above zero, as by ringing of
/// V, becomes zero.

#include <cstdint>
#include <span>
#include <vector>

#include "cube/cube_image.h"
#include "shexp/tables.h"

namespace haarlight {

struct ExponentiationTables {
  /// Coefficients of one lobe and channel, padded with zeros to a multiple of 16.
  static constexpr int rowSize = 48;

  ShexpTables visibility;
  /// As in ShadingTables.
  std::vector<std::uint32_t> lobeSlots;
  /// ∫ L p y_k at (slot · 3 + channel) · rowSize + k.
  std::vector<float> lightLobes;

  /// The row of a slot and channel.
  std::span<const float> lightLobe(std::size_t slot, int channel) const {
    return std::span(lightLobes).subspan((slot * 3 + std::size_t(channel)) * rowSize, rowSize);
  }
  std::size_t slotCount() const { return lightLobes.size() / (3 * rowSize); }
};

/// Builds the tables. A lobe of importance 0 (lobeCount entries) is left black, so no receiver may
/// use it. Throws std::invalid_argument for an order that exponentiation is not offered for.
ExponentiationTables buildExponentiationTables(const RadianceCube& light, int order,
                                               std::span<const double> lobeImportance);

}  // namespace haarlight
