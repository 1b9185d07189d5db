#include "benchmark/scale.h"

#include <bit>
#include <functional>

#include "base/stopwatch.h"
#include "benchmark/inputs.h"
#include "verify/cases/paper_frame.h"

namespace haarlight::benchmark {

namespace {

constexpr double enoughSeconds = 2;
constexpr std::size_t fewestFrames = 3;

class ScaleMeasurement {
 public:
  ScaleMeasurement(Engine& engine, const RadianceCube& light, const Effort& effort,
                   std::size_t points)
      : engine_(engine), light_(light), effort_(effort), points_(points) {}

  /// Sizes, and the frame that each stands for.
  template <typename Size, typename Measure>
  Sweep sweep(const std::string& parameter, const std::vector<Size>& sizes,
              const Measure& measure) {
    Sweep result{parameter, {}, std::nullopt};
    std::vector<glm::dvec2> times;
    for (const Size size : sizes) {
      if (effort_.interrupted()) break;
      result.points.push_back({double(size), measure(size)});
      times.emplace_back(size, result.points.back().frame.median);
      if (effort_.progress)
        effort_.progress("measuring sizes", double(++measured_) / double(points_));
    }
    result.law = fitPowerLaw(times);
    return result;
  }

  Quartiles measure(std::size_t samples, const Setting& setting) {
    if (receivers_.size() != samples) receivers_ = planeReceivers(samples);
    const std::vector<Sphere> spheres = verify::paperFrame(setting.spheres).spheres;
    engine_.setShading(buildShadingTables(
        light_, {.terms = setting.terms, .levels = setting.levels}, countLobes(receivers_.lobes)));
    for (std::size_t i = 0; i < effort_.warmUpFrames; ++i) engine_.shade(spheres, receivers_);
    const Stopwatch watch;
    std::vector<double> seconds;
    const auto isEnough = [&] {
      return seconds.size() >= effort_.frames || effort_.interrupted() ||
             (seconds.size() >= fewestFrames && watch.total() >= enoughSeconds);
    };
    do {
      StageTimes times;
      engine_.shade(spheres, receivers_, &times);
      seconds.push_back(times.total);
    } while (!isEnough());
    return quartilesOf(seconds);
  }

 private:
  Engine& engine_;
  const RadianceCube& light_;
  const Effort& effort_;
  std::size_t points_, measured_ = 0;
  Receivers receivers_;
};

}  // namespace

ScalePlan scalePlan(std::size_t mostSamples) {
  ScalePlan plan;
  for (std::size_t samples = 1 << 10; samples <= mostSamples; samples *= 2)
    plan.samples.push_back(samples);
  for (int spheres = 8; spheres <= 1024; spheres *= 2) plan.spheres.push_back(spheres);
  plan.terms.push_back(0);
  for (int terms = 8; terms <= 4096; terms *= 2) plan.terms.push_back(terms);
  plan.terms.push_back(maximumTerms);
  return plan;
}

Receivers planeReceivers(std::size_t count) {
  const int bits = std::countr_zero(count);
  ReceiverDescription plane;
  plane.samples = {1 << (bits + 1) / 2, 1 << bits / 2};
  return receiversOf(planeSamplesInTiles(plane));
}

Scale measureScale(Engine& engine, const RadianceCube& light, const ScalePlan& plan,
                   const Effort& effort) {
  ScaleMeasurement measurement(engine, light, effort,
                               plan.samples.size() + plan.spheres.size() + plan.terms.size());
  Scale scale{0, plan.fixedSamples, plan.fixed, {}};
  scale.sweeps.push_back(measurement.sweep("samples", plan.samples, [&](std::size_t samples) {
    return measurement.measure(samples, plan.fixed);
  }));
  const auto sweepSetting = [&](const char* name, const std::vector<int>& sizes,
                                int Setting::*parameter) {
    scale.sweeps.push_back(measurement.sweep(name, sizes, [&](int size) {
      Setting setting = plan.fixed;
      setting.*parameter = size;
      return measurement.measure(plan.fixedSamples, setting);
    }));
  };
  sweepSetting("spheres", plan.spheres, &Setting::spheres);
  sweepSetting("terms", plan.terms, &Setting::terms);
  return scale;
}

}  // namespace haarlight::benchmark
