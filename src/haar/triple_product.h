#pragma once

#include "haar/transform.h"

namespace haarlight {

/// The integral over one face of the product of three functions, by the paper's theorem on the
/// non-zero triple coefficients C_uvw = ∫ b_u b_v b_w (§3.5, method.md §5):
///
///   (1) Φ, Φ, Φ: 1;
///   (2) the same square, three different types: 2^l;
///   (3) the same wavelet twice, the third Φ: 1, or a strictly coarser wavelet over the square:
///       ± 2^l of the third, with its sign on the square.
///
/// All coarser wavelets of (3) and Φ together are the mean of the third function over the square.
/// Sums in the order of the formula, in double: the definition every engine is compared with.
double tripleProduct(const HaarFace<double>& light, const HaarFace<double>& visibility,
                     const HaarFace<double>& lobe);

/// The sum of tripleProduct over the six faces.
double tripleProduct(const HaarCube<double>& light, const HaarCube<double>& visibility,
                     const HaarCube<double>& lobe);

/// C_uvw of a face by the theorem, for coefficient indices u, v, w.
double tripleCoefficient(int u, int v, int w);

}  // namespace haarlight
