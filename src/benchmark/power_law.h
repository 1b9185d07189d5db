#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace haarlight::benchmark {

/// With which power of a size n a time grows.
struct PowerLaw {
  /// Slope of log time over log n by least squares, over all sizes above 0.
  double exponent = 0;
  /// The same over the upper half of them, where a fixed cost weighs less.
  double upperHalfExponent = 0;
  /// Of the law seconds = fixedSeconds + factor · n^exponent that fits all sizes, 0 too, with the
  /// least squares of relative errors; no part is negative, and the exponent lies in 0.05 … 3.
  double exponentAboveFixed = 0;
  double fixedSeconds = 0;
};

/// Fits the law to points (n, seconds > 0) in ascending order of n. Nothing when fewer than four of
/// the sizes are above 0.
std::optional<PowerLaw> fitPowerLaw(std::span<const glm::dvec2> points);

}  // namespace haarlight::benchmark
