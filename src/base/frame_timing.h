#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace haarlight {

/// The middle one of `values` (of an even number, the upper of the two in the middle). Needs one.
double median(std::vector<double> values);

struct FrameTiming {
  std::size_t frames = 0;
  double medianSeconds = 0, minimumSeconds = 0;

  double framesPerSecond() const { return 1 / medianSeconds; }
};

/// Calls `frame`, which returns how many seconds it took, once to warm caches up, then for about a
/// second: at least 5 and at most 100 times.
FrameTiming timeFrames(const std::function<double()>& frame);

}  // namespace haarlight
