#pragma once

#include <cmath>
#include <utility>

namespace haarlight {

/// The value and the slope of a function.
struct ValueAndSlope {
  double value, slope;
};

/// Where a continuous function passes through zero between low and high, at one of which it is
/// positive and at the other not: by Newton's steps, and by halving where these leave the bracket
/// or shrink too slowly. Exact to the last bits that the function's values know.
template <typename Function>
double rootBetween(const Function& function, double low, double high) {
  if (function(low).value > 0) std::swap(low, high);  // now it is positive at high
  double s = low + (high - low) / 2, lastStep = std::abs(high - low);
  for (int i = 0; i < 200; ++i) {
    const ValueAndSlope f = function(s);
    (f.value > 0 ? high : low) = s;
    const double step = -f.value / f.slope;
    if (s + step == s) return s;
    const bool inside =
        (s + step - low) * (s + step - high) < 0;  // false too for what is no number
    const bool fast = inside && std::abs(step) <= lastStep / 2;
    const double next = fast ? s + step : low + (high - low) / 2;
    lastStep = std::abs(next - s);
    if (next == s || next == low || next == high) return next;
    s = next;
  }
  return s;
}

}  // namespace haarlight
