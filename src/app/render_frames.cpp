#include "app/render_frames.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/interrupt.h"
#include "base/frame_timing.h"
#include "base/peak_memory.h"
#include "base/stopwatch.h"
#include "image/tonemap.h"
#include "scene/keyframes.h"

namespace haarlight {

namespace {

/// Seconds of one frame by what they were spent on.
struct FrameTimes {
  ShowTimes show;
  double rays = 0;  ///< camera rays and what they need
  StageTimes shading;
  double punctual = 0;  ///< of light and shading: punctual lights and their shadows
  double write = 0;
  double total = 0;
};

nlohmann::ordered_json describe(const FrameTimes& times) {
  return {{"total", times.total},
          {"meshes", times.show.meshes},
          {"spheres", times.show.spheres},
          {"light", times.show.light},
          {"rays", times.rays},
          {"shading", describeStages(times.shading)},
          {"punctual", times.punctual},
          {"write", times.write}};
}

class FrameRenderer {
 public:
  FrameRenderer(ShadingSetup& setup, const std::vector<std::string>& outputs,
                const FrameSettings& settings)
      : setup_(setup),
        settings_(settings),
        description_(setup.description()),
        targets_(outputs, description_.image, description_.animation.framesPerSecond) {}

  nlohmann::ordered_json run();

 private:
  void prepare();
  FrameTimes render(int frame);
  void showProgress(int done);
  nlohmann::ordered_json results() const;

  ShadingSetup& setup_;
  const FrameSettings& settings_;
  const SceneDescription& description_;
  FrameTargets targets_;
  std::unique_ptr<RadianceMethod> method_;
  float stops_ = 0;
  bool interrupted_ = false;
  int skipped_ = 0;
  std::vector<FrameTimes> times_;
  nlohmann::ordered_json frames_ = nlohmann::ordered_json::array();
};

/// What all frames share, from second 0.
void FrameRenderer::prepare() {
  ImageDescription small = description_.image;
  small.width = std::max(1, small.width / 8);
  small.height = std::max(1, small.height / 8);
  small.samplesPerPixel = 1;
  const CameraDescription camera = cameraAt(description_.camera, 0);
  const ScreenSampler sampler(setup_.scene(), camera, description_.image);
  method_ = setup_.method(description_.shading.method, sampler.overview(), true);
  if (description_.image.exposure) {
    stops_ = float(*description_.image.exposure);
    return;
  }
  const ScreenSampler smallSampler(setup_.scene(), camera, small);
  stops_ = automaticExposure(smallSampler.render(*method_).radiance);
}

FrameTimes FrameRenderer::render(int frame) {
  FrameTimes times;
  Stopwatch watch;
  const double seconds = frameSeconds(description_.animation, frame);
  const double punctualBefore = method_->punctualSeconds();
  times.show = setup_.show(seconds, *method_);
  watch.lap();
  const StageTimes before = method_->times();
  const ScreenSampler sampler(setup_.scene(), cameraAt(description_.camera, seconds),
                              description_.image);
  const RenderedImage picture = sampler.render(*method_);
  times.shading = method_->times() - before;
  times.rays = watch.lap() - times.shading.total;
  times.punctual = method_->punctualSeconds() - punctualBefore;
  ImageAttributes attributes = setup_.attributes(*method_);
  attributes["frame"] = frame;
  attributes["seconds"] = float(seconds);
  targets_.write(frame, picture, stops_, attributes);
  times.write = watch.lap();
  times.total = watch.total();
  return times;
}

void FrameRenderer::showProgress(int done) {
  std::vector<double> totals;
  for (const FrameTimes& times : times_) totals.push_back(times.total);
  if (!totals.empty())
    setup_.console().progressDetail(fmt::format("{:.3g} frames/s", 1 / median(totals)));
  if (const auto progress = setup_.console().progress())
    progress(fmt::format("rendering {} frames", settings_.range.count()),
             double(done) / settings_.range.count());
}

nlohmann::ordered_json FrameRenderer::results() const {
  nlohmann::ordered_json results{
      {"frames_first", settings_.range.first},
      {"frames_last", settings_.range.last},
      {"frames_rendered", times_.size()},
      {"frames_skipped", skipped_},
      {"scene_frames_per_second", description_.animation.framesPerSecond},
      {"size", fmt::format("{}x{}", description_.image.width, description_.image.height)}};
  if (!targets_.clips().empty() && !times_.empty()) results["clips"] = targets_.clips();
  if (interrupted_) results["interrupted"] = true;
  if (method_) results.update(setup_.summary(*method_));
  if (!times_.empty()) {
    const auto medianOf = [&](const auto& value) {
      std::vector<double> values;
      for (const FrameTimes& times : times_) values.push_back(value(times));
      return median(values);
    };
    results["exposure_stops"] = stops_;
    results["median_seconds"] = {
        {"total", medianOf([](const FrameTimes& t) { return t.total; })},
        {"meshes", medianOf([](const FrameTimes& t) { return t.show.meshes; })},
        {"spheres", medianOf([](const FrameTimes& t) { return t.show.spheres; })},
        {"light", medianOf([](const FrameTimes& t) { return t.show.light; })},
        {"rays", medianOf([](const FrameTimes& t) { return t.rays; })},
        {"shading", medianOf([](const FrameTimes& t) { return t.shading.total; })},
        {"punctual", medianOf([](const FrameTimes& t) { return t.punctual; })},
        {"write", medianOf([](const FrameTimes& t) { return t.write; })}};
  }
  results["peak_memory_mib"] = peakMemoryMebibytes();
  if (settings_.listFrames) results["frames"] = frames_;
  return results;
}

nlohmann::ordered_json FrameRenderer::run() {
  const InterruptWatch interrupt;
  for (int frame = settings_.range.first; frame <= settings_.range.last; ++frame) {
    nlohmann::ordered_json entry{{"frame", frame}, {"pictures", targets_.pictures(frame)}};
    if (settings_.resume && targets_.isComplete(frame)) {
      ++skipped_;
      entry["skipped"] = true;
    } else {
      if (!method_) prepare();
      times_.push_back(render(frame));
      entry["seconds"] = describe(times_.back());
    }
    frames_.push_back(entry);
    showProgress(frame - settings_.range.first + 1);
    interrupted_ = interrupt.interrupted();
    if (interrupted_) break;
  }
  if (!times_.empty()) targets_.finish();
  return results();
}

}  // namespace

nlohmann::ordered_json renderFrames(ShadingSetup& setup, const std::vector<std::string>& outputs,
                                    const FrameSettings& settings) {
  return FrameRenderer(setup, outputs, settings).run();
}

}  // namespace haarlight
