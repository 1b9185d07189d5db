#include "benchmark/tuning.h"

#include <algorithm>
#include <cmath>

#include "base/frame_timing.h"
#include "base/stopwatch.h"
#include "verify/cases/paper_frame.h"

namespace haarlight::benchmark {

namespace {

constexpr int paperSpheres = 64;

double medianSeconds(Engine& engine, const verify::Case& frame, const TuningFrames& frames) {
  engine.setShading(buildShadingTables(frame.light, {200, 2}, countLobes(frame.receivers.lobes)));
  const ReceiverSpan receivers =
      ReceiverSpan(frame.receivers).part(0, std::min(frames.samples, frame.receivers.size()));
  for (std::size_t i = 0; i < frames.warmUpFrames && !frames.interrupted(); ++i)
    engine.shade(frame.spheres, receivers);
  std::vector<double> seconds;
  while (seconds.size() < frames.frames && !frames.interrupted()) {
    const Stopwatch watch;
    engine.shade(frame.spheres, receivers);
    seconds.push_back(watch.total());
  }
  return seconds.empty() ? 0 : median(seconds);
}

}  // namespace

std::vector<ShapeTiming> timeShapes(std::span<const KernelShape> shapes, const TimeShape& time,
                                    const Interrupted& interrupted) {
  std::vector<ShapeTiming> timings;
  for (const KernelShape& shape : shapes) {
    if (interrupted()) break;
    ShapeTiming timing{shape, {}, {}};
    try {
      timing.seconds = time(shape);
    } catch (const std::exception& problem) {  // of this shape; others may work
      timing.failure = problem.what();
    }
    if (!interrupted()) timings.push_back(timing);
  }
  return timings;
}

const ShapeTiming* chosenShape(std::span<const ShapeTiming> timings, const KernelShape& standard) {
  const auto mean = [](const ShapeTiming& t) {
    return std::sqrt(t.seconds.exact * t.seconds.table);
  };
  const ShapeTiming* best = nullptr;
  for (const ShapeTiming& timing : timings)
    if (timing.failure.empty() && (!best || mean(timing) < mean(*best))) best = &timing;
  for (const ShapeTiming& timing : timings)
    if (timing.shape == standard && timing.failure.empty() &&
        mean(*best) > (1 - worthwhileSaving) * mean(timing))
      return &timing;
  return best;
}

ShapeSeconds timePaperFrame(const DeviceDescription& device, const KernelShape& shape,
                            const TuningFrames& frames) {
  const verify::Case frame = verify::paperFrame(paperSpheres);
  EngineOptions options = optionsFor(device);
  options.lanesPerItem = shape.lanesPerItem;
  options.samplesPerGroup = shape.samplesPerGroup;
  ShapeSeconds seconds;
  seconds.exact = medianSeconds(*makeEngine(options, nullptr), frame, frames);
  if (!frames.interrupted())
    seconds.table = medianSeconds(*makeEngine(options, frames.table), frame, frames);
  return seconds;
}

}  // namespace haarlight::benchmark
