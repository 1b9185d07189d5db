#include "app/frame_rate.h"

#include "base/frame_timing.h"

namespace haarlight {

nlohmann::ordered_json measureFrameRate(RadianceMethod& method,
                                        std::span<const SurfaceSample> samples) {
  const FrameTiming timing = timeFrames([&] {
    const double before = method.times().total;
    method.newFrame();
    method.radiance(samples);
    return method.times().total - before;
  });
  return {{"samples", samples.size()},
          {"frames_measured", timing.frames},
          {"seconds_per_frame_median", timing.medianSeconds},
          {"seconds_per_frame_minimum", timing.minimumSeconds},
          {"frames_per_second", timing.framesPerSecond()}};
}

}  // namespace haarlight
