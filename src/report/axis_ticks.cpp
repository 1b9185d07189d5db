#include "report/axis_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text_format.h"

namespace haarlight {

namespace {

constexpr std::array<int, 3> roundNumbers{1, 2, 5};

/// number · 10^exponent without a rounding of 10^-1 and the like, so that it is written shortly.
double decimal(double number, int exponent) {
  return exponent < 0 ? number / std::pow(10, -exponent) : number * std::pow(10, exponent);
}

struct Step {
  int number = 1;
  int exponent = 0;

  double size() const { return decimal(number, exponent); }
};

Step smallestStepOfAtLeast(double size) {
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  for (const int number : roundNumbers)
    if (decimal(number, exponent) >= size) return {number, exponent};
  return {1, exponent + 1};
}

}  // namespace

std::vector<double> linearTicks(double lower, double upper, int wanted) {
  const double size = std::max(std::abs(lower), std::abs(upper));
  // Numbers that are as good as one have its size as their range.
  const bool isRange = upper - lower > 1e-9 * size;
  const double range = isRange ? upper - lower : size > 0 ? size : 1;
  const Step step = smallestStepOfAtLeast(range / wanted);
  const double first = std::floor(lower / step.size());
  const double last = std::max(std::ceil(upper / step.size()), first + 1);
  std::vector<double> ticks;
  for (double i = first; i <= last; ++i) ticks.push_back(decimal(i * step.number, step.exponent));
  return ticks;
}

std::vector<double> logarithmicTicks(double lower, double upper) {
  const bool fine = upper < 1000 * lower;
  std::vector<double> ticks;
  for (int exponent = static_cast<int>(std::floor(std::log10(lower))) - 1;; ++exponent)
    for (const int number : roundNumbers) {
      if (number > 1 && !fine) continue;
      const double tick = decimal(number, exponent);
      if (tick <= lower) ticks.clear();
      ticks.push_back(tick);
      if (tick >= upper && ticks.size() > 1) return ticks;
    }
}

std::string tickLabel(double tick) {
  const bool plain = tick == 0 || (std::abs(tick) >= 1e-6 && std::abs(tick) < 1e9);
  return plain ? numberText(tick, std::chars_format::fixed) : numberText(tick);
}

}  // namespace haarlight
