#include "spheres/fit_monitor.h"

#include <algorithm>

namespace haarlight {

void FitMonitor::beginHalfOfRest() {
  fitFrom_ = finished_;
  fitTo_ = (1 + finished_) / 2;
}

void FitMonitor::beginPhase(const std::string& phase, double from, double to) {
  phase_ = phase;
  phaseFrom_ = from;
  phaseTo_ = to;
}

void FitMonitor::report(double part, std::size_t spheres, double error) {
  if (bestElsewhere_) error = std::min(error, *bestElsewhere_);
  history_.push_back({phase_, seconds(), spheres, error});
  const double ofFit = phaseFrom_ + std::min(part, 1.0) * (phaseTo_ - phaseFrom_);
  finished_ = fitFrom_ + ofFit * (fitTo_ - fitFrom_);
  if (options_.progress) options_.progress({finished_, error});
}

bool FitMonitor::mustStop() {
  if (interruption_ != FitStop::converged) return true;
  if (options_.cancelled && options_.cancelled()) interruption_ = FitStop::cancelled;
  if (options_.timeLimit && seconds() >= *options_.timeLimit) interruption_ = FitStop::timeLimit;
  return interruption_ != FitStop::converged;
}

double FitMonitor::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

FitStop FitMonitor::stop() const {
  return errorReached_ && interruption_ == FitStop::converged ? FitStop::errorReached
                                                              : interruption_;
}

}  // namespace haarlight
