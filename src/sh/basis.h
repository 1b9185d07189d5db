#pragma once

/// The real spherical-harmonic basis: its conventions, and its values at a direction.
///
/// *Order n* means n bands: degrees l = 0 … n − 1 with 2l + 1 functions each, m = −l … l, n² in
/// all. The function of degree l and m has index l(l + 1) + m.
///
/// With θ from the +z axis and φ from +x towards +y,
///
///     y_lm = K_l|m| P_l|m|(cos θ) · { √2 cos mφ  for m > 0,   1  for m = 0,   √2 sin |m|φ  for m <
///     0 } K_lm = √((2l + 1)/4π · (l − m)!/(l + m)!)
///
/// where the associated Legendre function P carries the Condon–Shortley sign (−1)^m. So band 1 is
/// √(3/4π) (−y, z, −x). The functions are orthonormal over the unit sphere: ∫ y_i y_j dω = δ_ij,
/// dω in steradians. Directions are the caller's: nothing here knows which axis points up
/// (sh/conventions.h turns coefficients from one convention to another).
///
/// After R. Green, "Spherical Harmonic Lighting: The Gritty Details" (GDC 2003).

#include <glm/vec3.hpp>
#include <span>

namespace haarlight {

/// Largest order that tables are held for.
inline constexpr int maximumShOrder = 64;

/// Number of functions, and of coefficients, of an order.
constexpr int shCoefficientCount(int order) {
  return order * order;
}

/// Index of degree l ≥ 0 and m = −l … l.
constexpr int shIndex(int l, int m) {
  return l * (l + 1) + m;
}

/// Degree of the function with an index.
constexpr int shDegree(int index) {
  int l = 0;
  while (shCoefficientCount(l + 1) <= index) ++l;
  return l;
}

/// Throws std::invalid_argument unless 1 ≤ order ≤ maximumShOrder.
void requireShOrder(int order);

/// Writes all order² functions at a unit direction to `values`, in index order. `Real` is float or
/// double. Recurrences over polynomials of x, y, z only: no angles, no factorials, no case at the
/// poles. Throws std::invalid_argument for a wrong order or a span of another size.
template <typename Real>
void evaluateShBasis(int order, const glm::vec<3, Real>& direction, std::span<Real> values);

/// The functions with m = 0 depend on z = cos θ alone: writes y_l0 for l < values.size(), which is
/// an order.
void evaluateZonalBasis(double z, std::span<double> values);

}  // namespace haarlight
