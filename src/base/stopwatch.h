#pragma once

#include <chrono>
#include <utility>

namespace haarlight {

/// Seconds between calls.
class Stopwatch {
 public:
  /// Since the last lap, or since the watch was made.
  double lap() {
    const auto last = std::exchange(last_, Clock::now());
    return std::chrono::duration<double>(last_ - last).count();
  }

  /// Since the watch was made.
  double total() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace haarlight
