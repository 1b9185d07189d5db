#pragma once

/// Logarithm and exponential of functions on the sphere *in the algebra of the truncated product*
/// of sh/triple_tensor.h (Ren et al., "Real-time Soft Shadows in Dynamic Scenes using Spherical
/// Harmonic Exponentiation", SIGGRAPH 2006). In double, on the host: what tables are made from and
/// what the fast exponential is judged by.

#include <functional>
#include <span>
#include <vector>

#include "sh/vector.h"

namespace haarlight {

/// Visibility past a sphere on the z axis as zonal coefficients (sh/zonal.h): 1, but 0 within the
/// cap cos θ ≥ `cosine` of the sphere's angular radius. In closed form for its linear integrals.
std::vector<double> capVisibility(int order, double cosine);

/// F of a zonal function: Σ_k F(λ_k) q_k (q_k · 1) with the eigenvalues λ and eigenvectors q of the
/// symmetric matrix that multiplies zonal functions by it. For F = exp this is the series
/// 1 + f + f²/2! + … of truncated products.
std::vector<double> zonalFunction(std::span<const double> zonal,
                                  const std::function<double(double eigenvalue)>& function);

/// Eigenvalues of visibility below this are taken for it, since a wholly blocked direction has no
/// logarithm. A smaller one gives a slightly better single sphere and a larger logarithm, which
/// then costs more squarings and precision: at order 4 and 60°, 0.1 leaves an RMS error of 0.071,
/// 0.02 one of 0.041 and 0.005 one of 0.036, with norms of 2.9, 4.9 and 6.6.
inline constexpr double smallestVisibility = 0.02;

/// The paper's logarithm: zonalFunction with log(max(λ, smallestVisibility)).
std::vector<double> zonalLogarithm(std::span<const double> visibility);

/// exp of any function by truncated products, 1 + f + f²/2! + …, to rounding error.
ShVector<double> shExponential(const ShVector<double>& f);

}  // namespace haarlight
