#pragma once

#include <cstddef>
#include <vector>

namespace haarlight::benchmark {

/// How the times of one thing that was done several times are spread, in seconds.
struct Quartiles {
  std::size_t count = 0;
  double minimum = 0;
  double lower = 0;
  double median = 0;
  double upper = 0;

  double perSecond() const { return 1 / median; }
};

/// Of `seconds` (at least one) in ascending order, those at a quarter, half and three quarters of
/// the count, rounded down: the median is that of base/frame_timing.h.
Quartiles quartilesOf(std::vector<double> seconds);

}  // namespace haarlight::benchmark
