#pragma once

#include "haar/basis.h"

namespace haarlight {

/// Wavelets of all six faces; the Φ of the faces are always kept and not counted.
inline constexpr int waveletCount = faceCount * (coefficientsPerFace - 1);
inline constexpr int maximumTerms = texelCount;

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

  bool isComplete() const { return terms >= waveletCount; }
};

}  // namespace haarlight
