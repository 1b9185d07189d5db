#include "sh/basis.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace haarlight {

namespace {

/// With s = sin θ, the normalised Legendre functions p_lm = √2 K_lm P_lm / s^m (without √2 for
/// m = 0) obey
///
///     p_mm = diagonal[m],   p_lm = first[l, m] z p_(l−1)m − second[l, m] p_(l−2)m
///
/// where first and second follow from the recurrence of P and the ratios of the K.
template <typename Real>
struct LegendreRecurrence {
  static constexpr int entryCount = maximumShOrder * (maximumShOrder + 1) / 2;

  std::array<Real, maximumShOrder> diagonal;
  std::array<Real, entryCount> first{}, second{};

  static constexpr int entry(int l, int m) { return l * (l + 1) / 2 + m; }

  LegendreRecurrence() {
    double value = std::sqrt(0.25 / std::numbers::pi);
    diagonal[0] = Real(value);
    value *= std::numbers::sqrt2;
    for (int m = 1; m < maximumShOrder; ++m) {
      value *= -std::sqrt((2 * m + 1) / (2.0 * m));
      diagonal[m] = Real(value);
    }
    for (int l = 1; l < maximumShOrder; ++l)
      for (int m = 0; m < l; ++m) {
        const double squares = l * l - m * m, before = (l - 1) * (l - 1) - m * m;
        first[entry(l, m)] = Real(std::sqrt((4.0 * l * l - 1) / squares));
        if (l > m + 1)
          second[entry(l, m)] = Real(std::sqrt((2 * l + 1) * before / ((2 * l - 3) * squares)));
      }
  }

  /// Calls visit(l, p_lm) for l = m … order − 1.
  template <typename Visit>
  void column(int order, int m, Real z, const Visit& visit) const {
    Real previous = 0, current = diagonal[m];
    visit(m, current);
    for (int l = m + 1; l < order; ++l) {
      const Real next = first[entry(l, m)] * z * current - second[entry(l, m)] * previous;
      previous = current;
      current = next;
      visit(l, current);
    }
  }
};

template <typename Real>
const LegendreRecurrence<Real>& legendreRecurrence() {
  static const LegendreRecurrence<Real> recurrence;
  return recurrence;
}

}  // namespace

void requireShOrder(int order) {
  if (order < 1 || order > maximumShOrder)
    throw std::invalid_argument("the order of spherical harmonics is 1 to " +
                                std::to_string(maximumShOrder) + ", not " + std::to_string(order));
}

template <typename Real>
void evaluateShBasis(int order, const glm::vec<3, Real>& direction, std::span<Real> values) {
  requireShOrder(order);
  if (int(values.size()) != shCoefficientCount(order))
    throw std::invalid_argument("spherical harmonics of order n have n² values");
  const auto& recurrence = legendreRecurrence<Real>();
  recurrence.column(order, 0, direction.z, [&](int l, Real p) { values[shIndex(l, 0)] = p; });
  // (x + iy)^m = s^m (cos mφ + i sin mφ)
  Real cosine = 1, sine = 0;
  for (int m = 1; m < order; ++m) {
    const Real before = cosine;
    cosine = direction.x * cosine - direction.y * sine;
    sine = direction.x * sine + direction.y * before;
    recurrence.column(order, m, direction.z, [&](int l, Real p) {
      values[shIndex(l, m)] = p * cosine;
      values[shIndex(l, -m)] = p * sine;
    });
  }
}

template void evaluateShBasis(int, const glm::vec<3, float>&, std::span<float>);
template void evaluateShBasis(int, const glm::vec<3, double>&, std::span<double>);

void evaluateZonalBasis(double z, std::span<double> values) {
  const int order = int(values.size());
  requireShOrder(order);
  legendreRecurrence<double>().column(order, 0, z, [&](int l, double p) { values[l] = p; });
}

}  // namespace haarlight
