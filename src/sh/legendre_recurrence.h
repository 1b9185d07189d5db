#pragma once

#include <array>

#include "sh/basis.h"

namespace haarlight {

/// The recurrence of normalised Legendre functions, p_lm = √2 K_lm P_lm / s^m (without √2 for
/// m = 0) with s = sin θ and z = cos θ:
///
///     p_mm = diagonal[m],   p_lm = first[l, m] z p_(l−1)m − second[l, m] p_(l−2)m
///
/// where first and second follow from the recurrence of P and the ratios of the K.
template <typename Real>
struct LegendreRecurrence {
  static constexpr int entryCount = maximumShOrder * (maximumShOrder + 1) / 2;

  std::array<Real, maximumShOrder> diagonal;
  std::array<Real, entryCount> first{}, second{};

  /// Place of l, m in first and second.
  static constexpr int entry(int l, int m) { return l * (l + 1) / 2 + m; }

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

/// The table, made at the first call. `Real` is float or double.
template <typename Real>
const LegendreRecurrence<Real>& legendreRecurrence();

}  // namespace haarlight
