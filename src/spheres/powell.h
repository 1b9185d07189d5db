#pragma once

#include <functional>
#include <span>

namespace haarlight {

/// Where a search for a minimum starts and ends.
struct PowellOptions {
  double firstStep = 1;        ///< in every coordinate
  double smallestStep = 1e-3;  ///< ends the search
  int mostEvaluations = 100;
};

/// Moves `place`, of 2 to some ten coordinates, to where `cost` is small, without derivatives, and
/// returns the cost there, which is never above that at the start: Powell's method of quadratic
/// models in a trust region (BOBYQA, Powell 2009), as NLopt has it. Deterministic.
double minimizeByPowell(std::span<double> place,
                        const std::function<double(std::span<const double>)>& cost,
                        const PowellOptions& options);

}  // namespace haarlight
