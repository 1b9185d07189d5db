#include "sh/basis.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sh/legendre_recurrence.h"

namespace haarlight {

namespace {

template <typename Real>
LegendreRecurrence<Real> makeRecurrence() {
  LegendreRecurrence<Real> recurrence;
  double value = std::sqrt(0.25 / std::numbers::pi);
  recurrence.diagonal[0] = Real(value);
  value *= std::numbers::sqrt2;
  for (int m = 1; m < maximumShOrder; ++m) {
    value *= -std::sqrt((2 * m + 1) / (2.0 * m));
    recurrence.diagonal[m] = Real(value);
  }
  for (int l = 1; l < maximumShOrder; ++l)
    for (int m = 0; m < l; ++m) {
      const double squares = l * l - m * m, before = (l - 1) * (l - 1) - m * m;
      const int entry = recurrence.entry(l, m);
      recurrence.first[entry] = Real(std::sqrt((4.0 * l * l - 1) / squares));
      if (l > m + 1)
        recurrence.second[entry] = Real(std::sqrt((2 * l + 1) * before / ((2 * l - 3) * squares)));
    }
  return recurrence;
}

}  // namespace

template <typename Real>
const LegendreRecurrence<Real>& legendreRecurrence() {
  static const LegendreRecurrence<Real> recurrence = makeRecurrence<Real>();
  return recurrence;
}

template const LegendreRecurrence<float>& legendreRecurrence();
template const LegendreRecurrence<double>& legendreRecurrence();

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
