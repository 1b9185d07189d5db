#include "app/frame_rate.h"

#include <algorithm>
#include <chrono>

namespace haarlight {

nlohmann::ordered_json measureFrameRate(RadianceMethod& method,
                                        std::span<const SurfaceSample> samples) {
  using Clock = std::chrono::steady_clock;
  const auto secondsSince = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  method.radiance(samples);  // warms caches up
  std::vector<double> seconds;
  const auto begin = Clock::now();
  while (seconds.size() < 5 || (secondsSince(begin) < 1 && seconds.size() < 100)) {
    const double before = method.times().total;
    method.radiance(samples);
    seconds.push_back(method.times().total - before);
  }
  std::ranges::sort(seconds);
  const double median = seconds[seconds.size() / 2];
  return {{"samples", samples.size()},
          {"frames_measured", seconds.size()},
          {"seconds_per_frame_median", median},
          {"seconds_per_frame_minimum", seconds.front()},
          {"frames_per_second", 1 / median}};
}

}  // namespace haarlight
