#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spheres/fit_spheres.h"

namespace haarlight {

/// What the parts of a fit tell while they run, and what they ask: how much is done, how good the
/// set is, and whether to stop. For one thread.
class FitMonitor {
 public:
  explicit FitMonitor(const SphereFitOptions& options)
      : options_(options), start_(std::chrono::steady_clock::now()) {}

  /// The next fit takes half of what is left of the progress; without this, a fit takes all.
  void beginHalfOfRest();

  /// A part of a fit runs from one finished part of it to another, 0 … 1.
  void beginPhase(const std::string& phase, double from, double to);

  /// A set with this error has been found, against which a new start only counts when it is better.
  void compareWith(std::optional<double> error) { bestElsewhere_ = error; }

  /// `part` of the current phase is done and the best set so far has this many spheres and error.
  void report(double part, std::size_t spheres, double error);

  /// Whether the time is over or the caller has cancelled; once true, it stays so.
  bool mustStop();

  /// A set with SphereFitOptions::maximumError has been found.
  void reachError() { errorReached_ = true; }

  /// As last reported.
  double lastError() const { return history_.empty() ? 0 : history_.back().error; }
  double seconds() const;
  FitStop stop() const;

  /// The history so far, which is left empty.
  std::vector<FitStep> takeHistory() { return std::move(history_); }

 private:
  const SphereFitOptions& options_;
  std::chrono::steady_clock::time_point start_;
  std::string phase_;
  double fitFrom_ = 0, fitTo_ = 1;      ///< of the whole
  double phaseFrom_ = 0, phaseTo_ = 1;  ///< of the fit
  double finished_ = 0;
  std::vector<FitStep> history_;
  std::optional<double> bestElsewhere_;
  bool errorReached_ = false;
  FitStop interruption_ = FitStop::converged;
};

}  // namespace haarlight
