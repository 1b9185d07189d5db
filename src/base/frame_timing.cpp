#include "base/frame_timing.h"

#include <algorithm>
#include <chrono>

namespace haarlight {

namespace {

constexpr double enoughSeconds = 1;
constexpr std::size_t fewestFrames = 5, mostFrames = 100;

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

FrameTiming timeFrames(const std::function<double()>& frame) {
  frame();
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto isLongEnough = [&] {
    return std::chrono::duration<double>(Clock::now() - start).count() >= enoughSeconds;
  };
  std::vector<double> seconds;
  while (seconds.size() < fewestFrames || (!isLongEnough() && seconds.size() < mostFrames))
    seconds.push_back(frame());
  return {seconds.size(), median(seconds), *std::ranges::min_element(seconds)};
}

}  // namespace haarlight
