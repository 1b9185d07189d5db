#include "benchmark/power_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace haarlight::benchmark {

namespace {

double logarithmicSlope(std::span<const glm::dvec2> points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const glm::dvec2& point : points) {
    const double logSize = std::log(point.x), logSeconds = std::log(point.y);
    x += logSize;
    y += logSeconds;
    xx += logSize * logSize;
    xy += logSize * logSeconds;
  }
  const double count = double(points.size());
  return (count * xy - x * y) / (count * xx - x * x);
}

/// seconds = fixed + factor · (n / largest n)^exponent.
struct Law {
  double exponent = 0, fixed = 0, factor = 0;
  /// Sum of the squares of relative errors.
  double error = std::numeric_limits<double>::infinity();
};

/// The best law of this exponent: least squares that are linear in the other two.
Law bestLaw(std::span<const glm::dvec2> points, double exponent) {
  const double largest = points.back().x;
  double s11 = 0, s12 = 0, s22 = 0, r1 = 0, r2 = 0;
  for (const glm::dvec2& point : points) {
    const double one = 1 / point.y, power = std::pow(point.x / largest, exponent) / point.y;
    s11 += one * one;
    s12 += one * power;
    s22 += power * power;
    r1 += one;
    r2 += power;
  }
  const double determinant = s11 * s22 - s12 * s12;
  Law law{exponent, (r1 * s22 - r2 * s12) / determinant, (r2 * s11 - r1 * s12) / determinant};
  if (!(law.fixed >= 0)) law = {exponent, 0, r2 / s22};
  if (!(law.factor >= 0)) law = {exponent, r1 / s11, 0};
  law.error = double(points.size()) - law.fixed * r1 - law.factor * r2;
  return law;
}

Law bestLaw(std::span<const glm::dvec2> points) {
  constexpr double lowest = 0.05, highest = 3, step = 0.01;
  Law best;
  const auto tryExponent = [&](double exponent) {
    const Law law = bestLaw(points, std::clamp(exponent, lowest, highest));
    if (law.error < best.error) best = law;
  };
  for (double exponent = lowest; exponent < highest; exponent += step) tryExponent(exponent);
  for (double width = step; width > 1e-7; width /= 2) {
    const double middle = best.exponent;
    tryExponent(middle - width);
    tryExponent(middle + width);
  }
  return best;
}

}  // namespace

std::optional<PowerLaw> fitPowerLaw(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> positive;
  std::ranges::copy_if(points, std::back_inserter(positive),
                       [](const glm::dvec2& point) { return point.x > 0; });
  if (positive.size() < 4) return std::nullopt;
  const Law law = bestLaw(points);
  return PowerLaw{
      .exponent = logarithmicSlope(positive),
      .upperHalfExponent = logarithmicSlope(std::span(positive).subspan(positive.size() / 2)),
      .exponentAboveFixed = law.exponent,
      .fixedSeconds = law.fixed};
}

}  // namespace haarlight::benchmark
