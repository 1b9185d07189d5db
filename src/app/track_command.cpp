#include <fmt/format.h>

#include <cstdio>

#include "app/commands.h"
#include "app/frame_targets.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/version.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "render/track.h"
#include "report/track_report.h"
#include "verify/report/host.h"

namespace haarlight {

namespace {

struct TrackOptions {
  GeneralOptions general;
  SceneOptions scene;
  std::string frames;
  std::optional<double> framesPerSecond;
  int every = 1;
  std::optional<int> refit;
  std::string compareTo;
  std::string plot;
  std::string report;
};

SceneDescription describe(const TrackOptions& options) {
  SceneDescription scene = describeScene(options.scene);
  if (options.framesPerSecond) scene.animation.framesPerSecond = *options.framesPerSecond;
  if (options.compareTo.empty()) return scene;
  if (!scene.receiver) throw InputError("--compare-to needs a receiver plane in the scene");
  const ShadingMethod method = scene.shading.method;
  if (method == ShadingMethod::PixelMesh)
    throw InputError(
        "--compare-to compares the method haar, pixel or shexp, not pixel-mesh with itself");
  if (method == ShadingMethod::Sh)
    throw InputError("--compare-to compares the method haar, pixel or shexp, not sh: objects move");
  return scene;
}

/// Makes the scene's method.
MethodMaker methodMaker(const TrackOptions& options, const SceneDescription& scene,
                        Console& console) {
  return [&](const Scene& loaded, std::span<const SurfaceSample> samples) {
    const auto table = openSphereTable(scene, console);
    if (scene.shading.method == ShadingMethod::Pixel) return makePixelMethod(loaded, table);
    const auto engine = openEngine(options.scene, scene, table, console);
    if (scene.shading.method == ShadingMethod::Shexp)
      return makeShexpMethod(loaded, engine, shexpOrder(scene.shading), samples, false);
    const ShadingSettings settings{.terms = scene.shading.terms, .levels = scene.shading.levels};
    return makeHaarMethod(loaded, engine, settings, samples, false);
  };
}

/// Measures the frames in ascending order, up to the one in which Ctrl-C is pressed.
void measureFrames(const TrackOptions& options, const FrameRange& range, SceneTracker& tracker,
                   Console& console, TrackReport& report) {
  const InterruptWatch watch;
  for (int frame = range.first; frame <= range.last; frame += options.every) {
    if (watch.interrupted()) {
      report.interrupted = true;
      break;
    }
    const bool refit = options.refit && report.frames.size() % std::size_t(*options.refit) == 0;
    report.frames.push_back(tracker.measure(frame, refit));
    if (const Progress progress = console.progress())
      progress(fmt::format("measuring frames {} to {}", range.first, range.last),
               double(frame - range.first + 1) / range.count());
  }
}

void printResults(const TrackOptions& options, const TrackReport& report, double seconds,
                  Console& console) {
  if (report.interrupted)
    console.warning(fmt::format("interrupted after frame {}", report.frames.back().frame));
  nlohmann::ordered_json results =
      options.general.json ? trackJson(report) : trackSummaryJson(report);
  results["seconds"] = seconds;
  if (!options.plot.empty()) results["plot"] = options.plot;
  if (!options.report.empty()) results["report"] = options.report;
  console.message(fmt::format(
      "{} measured in {:.1f} s",
      report.frames.size() == 1 ? "1 frame" : fmt::format("{} frames", report.frames.size()),
      seconds));
  if (!options.general.json) {
    const std::string table = trackText(report);
    std::fwrite(table.data(), 1, table.size(), stdout);  // main looks for errors on the stream
  }
  console.results(results);
}

void track(const TrackOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  if (!options.plot.empty()) checkTarget(options.plot, {".svg"});
  if (!options.report.empty()) checkTarget(options.report, {".html", ".json"});
  const SceneDescription scene = describe(options);
  const FrameRange range = options.frames.empty()
                               ? FrameRange{scene.animation.firstFrame, scene.animation.lastFrame}
                               : parseFrameRange(options.frames);
  SceneTracker tracker(scene, console.progress());
  for (const std::string& warning : tracker.warnings()) console.warning(warning);
  if (!options.compareTo.empty())
    tracker.comparePlane(methodMaker(options, scene, console), console.progress());
  Stopwatch watch;
  TrackReport report{.program = "haarlight " HAARLIGHT_VERSION,
                     .host = verify::hostDescription(),
                     .date = {},
                     .scene = options.scene.mesh.empty() ? options.scene.scene : options.scene.mesh,
                     .framesPerSecond = scene.animation.framesPerSecond,
                     .method = tracker.methodName(),
                     .objects = tracker.objectNames(),
                     .frames = {}};
  measureFrames(options, range, tracker, console, report);
  report.date = verify::utcNow();
  if (!options.plot.empty()) writeTrackReport(options.plot, report);
  if (!options.report.empty()) writeTrackReport(options.report, report);
  printResults(options, report, watch.total(), console);
}

void addFrameOptions(CLI::App& command, TrackOptions& options) {
  const auto add = [&](const char* name, auto& value, const char* help) {
    return command.add_option(name, value, help)->group("Animation");
  };
  add("--frames", options.frames, "Frames first:last to measure [those of the scene's animation]");
  add("--fps", options.framesPerSecond,
      "Frames per second: frame f shows second f / fps [the scene's]")
      ->check(CLI::Range(1e-3, 1e4));
  add("--every", options.every, "Only every N-th of these frames")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add("--refit", options.refit,
      "In every N-th frame measured also fit spheres from scratch, for comparison; slow")
      ->check(CLI::Range(1, 1000000));
}

}  // namespace

void addTrackCommand(CLI::App& app) {
  const auto options = std::make_shared<TrackOptions>();
  CLI::App* command =
      app.add_subcommand("track", "Measure how well moved spheres follow their meshes");
  command->footer(
      "Examples:\n"
      "  haarlight track builtin:twist --plot twist.svg\n"
      "  haarlight track scene.json --refit 10 --compare-to pixel-mesh --report track.html\n"
      "Radii are relative to those at second 0: 2 where a motion has doubled an object's size.\n"
      "Ctrl-C ends after the current frame with the figures so far.");
  addSceneOptions(*command, options->scene);
  addFrameOptions(*command, *options);
  command
      ->add_option("--compare-to", options->compareTo,
                   "pixel-mesh: also the root mean square error of the plane's radiance")
      ->group("Computation")
      ->check(CLI::IsMember({"pixel-mesh"}));
  command->add_option("--plot", options->plot, "Plots of the figures over frames to write (.svg)")
      ->group("Output");
  command
      ->add_option("--report", options->report,
                   "Report to write: .html with plots and table, or .json")
      ->group("Output");
  addGeneralOptions(*command, options->general);
  command->callback([options] { track(*options); });
}

}  // namespace haarlight
