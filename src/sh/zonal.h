#pragma once

/// Functions that are symmetric about an axis, f(ω) = g(ω · axis). With the axis along z only the
/// coefficients with m = 0 differ from zero, one per band: here "zonal coefficients", f_l for
/// l = 0 … order − 1.

#include <functional>
#include <span>
#include <vector>

#include "sh/vector.h"

namespace haarlight {

/// Zonal coefficients of g(cos θ) for cos θ in [from, to], 0 elsewhere: 2π ∫ g(z) y_l0(z) dz by
/// `points` Gauss–Legendre points, exact for polynomials g of degree 2·points − order. Throws
/// std::invalid_argument for a wrong order.
std::vector<double> projectZonal(int order, const std::function<double(double cosine)>& g,
                                 double from = -1, double to = 1, int points = 64);

/// Turns the axis from z to a unit direction v: f_lm = √(4π/(2l + 1)) f_l y_lm(v).
ShVector<double> rotateZonal(std::span<const double> zonal, const glm::dvec3& axis);

/// Zonal coefficients of max(0, cos θ) in closed form (Ramamoorthi and Hanrahan 2001, A_l with the
/// basis' norm): √π/2, √(π/3), 0 for the other odd l, and for even l
/// 2π √((2l + 1)/4π) (−1)^(l/2 − 1) / ((l + 2)(l − 1)) · l! / (2^l (l/2)!²).
std::vector<double> clampedCosineZonal(int order);

/// Factors √(4π/(2l + 1)) f_l by which convolution with a zonal function multiplies the bands:
/// scaleBands(light, convolutionFactors(clampedCosineZonal(n))) is irradiance by normal.
std::vector<double> convolutionFactors(std::span<const double> zonal);

}  // namespace haarlight
