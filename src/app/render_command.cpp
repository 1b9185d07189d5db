#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "app/commands.h"
#include "app/frame_rate.h"
#include "app/picture_file.h"
#include "app/picture_options.h"
#include "app/render_frames.h"
#include "app/shading_setup.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/peak_memory.h"
#include "image/contact_sheet.h"
#include "image/tonemap.h"
#include "render/render_image.h"
#include "report/method_sheet.h"
#include "scene/keyframes.h"
#include "scene/names.h"

namespace haarlight {

namespace {

struct RenderOptions {
  GeneralOptions general;
  SceneOptions scene;
  std::vector<std::string> outputs;
  PictureOptions picture;
  std::vector<std::string> compareTo;
  std::string sheet;
  bool frameRate = false;
  std::string frames;
  std::optional<double> framesPerSecond;
  bool resume = false;
};

SceneDescription describe(const RenderOptions& options) {
  SceneDescription scene = describeScene(options.scene);
  requireOrder(options.compareTo, scene.shading);
  applyPictureOptions(options.picture, scene.image);
  if (options.framesPerSecond) scene.animation.framesPerSecond = *options.framesPerSecond;
  return scene;
}

bool wantsFrames(const RenderOptions& options) {
  return !options.frames.empty() || options.resume || options.framesPerSecond ||
         std::ranges::any_of(options.outputs, namesFrames);
}

/// Writes the picture to every target and returns the exposure of the PNGs.
float writeOutputs(const RenderOptions& options, const RenderedImage& picture,
                   const ImageDescription& image, const ImageAttributes& attributes) {
  const float stops = image.exposure ? float(*image.exposure) : automaticExposure(picture.radiance);
  for (const std::string& output : options.outputs)
    writePicture(output, picture, stops, attributes);
  return stops;
}

/// The paper's frame: all samples of the receiver plane.
nlohmann::ordered_json planeFrameRate(ShadingSetup& setup) {
  const auto samples = planeSamplesInTiles(*setup.scene().receiver);
  const auto method = setup.method(setup.description().shading.method, samples, false);
  return measureFrameRate(*method, samples);
}

/// A method's picture for comparison.
struct Comparison {
  std::string method;
  RenderedImage picture;
  double seconds;
};

std::vector<Comparison> renderComparisons(ShadingSetup& setup, const ScreenSampler& sampler,
                                          const std::vector<std::string>& methods) {
  std::vector<Comparison> comparisons;
  for (const std::string& name : methods) {
    const auto method = setup.method(choiceOf(shadingMethodNames, name), sampler.overview(), true);
    RenderedImage picture = sampler.render(*method, setup.console().progress());
    comparisons.push_back({name, std::move(picture), method->times().total});
  }
  return comparisons;
}

/// The pictures side by side, and under every other one the first one's error against it.
Image comparisonSheet(const RenderedImage& picture, const std::string& methodName, float stops,
                      const std::vector<Comparison>& comparisons) {
  const Image exposed = tonemap(picture.radiance, stops);
  const Image empty(exposed.width, exposed.height);
  std::vector<Image> others, errors;
  for (const Comparison& other : comparisons) {
    others.push_back(tonemap(other.picture.radiance, stops));
    errors.push_back(differenceImage(exposed, others.back(), shownErrorScale));
  }
  std::vector<LabelledImage> upper{{methodName, exposed}};
  std::vector<LabelledImage> lower{{fmt::format("error x {}:", shownErrorScale), empty}};
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const ImageError error =
        compareImages(picture.radiance, comparisons[i].picture.radiance, picture.surfaceMask);
    upper.push_back({comparisons[i].method, others[i]});
    lower.push_back(
        {fmt::format("RMSE {:.2f} % of the mean", 100 * error.relativeRootMeanSquare), errors[i]});
  }
  return stackSheets(contactSheet(upper), contactSheet(lower));
}

void addComparisons(const RenderedImage& picture, const std::vector<Comparison>& comparisons,
                    nlohmann::ordered_json& results) {
  for (const Comparison& other : comparisons) {
    auto figures = describeError(
        compareImages(picture.radiance, other.picture.radiance, picture.surfaceMask), other.method);
    figures["seconds"] = other.seconds;
    results["comparison"].push_back(figures);
  }
}

void renderAnimation(const RenderOptions& options, Console& console) {
  if (!options.compareTo.empty() || !options.sheet.empty() || options.frameRate)
    throw InputError("--compare-to, --sheet and --frame-rate are for one picture, not for frames");
  SceneDescription scene = describe(options);
  FrameSettings settings;
  settings.range = options.frames.empty()
                       ? FrameRange{scene.animation.firstFrame, scene.animation.lastFrame}
                       : parseFrameRange(options.frames);
  settings.resume = options.resume;
  settings.listFrames = options.general.json;
  checkFrameTargets(options.outputs, settings.range, scene.animation.framesPerSecond,
                    settings.resume);
  ShadingSetup setup(options.scene, std::move(scene), console);
  setup.requireStillObjects();
  if (!setup.moves() && settings.range.count() > 1)
    console.warning("nothing in this scene moves: all frames are alike");
  console.results(renderFrames(setup, options.outputs, settings));
}

void renderStill(const RenderOptions& options, Console& console) {
  for (const std::string& output : options.outputs) checkTarget(output, {".png", ".exr"});
  if (!options.sheet.empty()) checkTarget(options.sheet, {".png"});
  if (!options.sheet.empty() && options.compareTo.empty())
    throw InputError("--sheet needs --compare-to");
  ShadingSetup setup(options.scene, describe(options), console);
  const SceneDescription& scene = setup.description();
  if (options.frameRate && !scene.receiver)
    throw InputError("--frame-rate needs a receiver plane in the scene");

  const auto start = std::chrono::steady_clock::now();
  const ScreenSampler sampler(setup.scene(), cameraAt(scene.camera, 0), scene.image);
  const auto method = setup.method(scene.shading.method, sampler.overview(), true);
  const RenderedImage picture = sampler.render(*method, console.progress());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const float stops = writeOutputs(options, picture, scene.image, setup.attributes(*method));

  nlohmann::ordered_json results{
      {"picture", options.outputs.front()},
      {"size", fmt::format("{}x{}", scene.image.width, scene.image.height)}};
  results.update(setup.summary(*method));
  results["exposure_stops"] = stops;
  results["samples_shaded"] = picture.surfaceSamples;
  results["seconds"] = seconds;
  results["shading_seconds"] = describeStages(method->times());
  results["peak_memory_mib"] = peakMemoryMebibytes();
  if (options.frameRate) results["plane_frame"] = planeFrameRate(setup);
  const auto comparisons = renderComparisons(setup, sampler, options.compareTo);
  addComparisons(picture, comparisons, results);
  if (!options.sheet.empty()) {
    writePng(options.sheet, comparisonSheet(picture, method->name(), stops, comparisons));
    results["sheet"] = options.sheet;
  }
  console.results(results);
}

void render(const RenderOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  if (wantsFrames(options))
    renderAnimation(options, console);
  else
    renderStill(options, console);
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render a picture of a scene");
  command->footer(
      "Examples:\n"
      "  haarlight render -o picture.png\n"
      "  haarlight render --mesh bunny.obj --light grace.hdr --spheres 64 -o bunny.png\n"
      "  haarlight render scene.json --method pixel-mesh -o reference.exr\n"
      "  haarlight render builtin:twist --size 480x270 -o twist.mp4\n"
      "  haarlight render scene.json --frames 0:95 --resume -o frame_%04d.png");
  addSceneOptions(*command, options->scene);
  command
      ->add_option(
          "-o,--output", options->outputs,
          "Picture to write: .png (sRGB) or .exr (linear float32); frames: frame_%04d.png, or "
          "clip.mp4, .webm or .gif by ffmpeg; may be repeated")
      ->allow_extra_args(false)
      ->required()
      ->group("Output");
  addPictureOptions(*command, options->picture, "960x540");
  command
      ->add_flag("--frame-rate", options->frameRate,
                 "Also measure frames per second of the receiver plane's samples")
      ->group("Computation");
  command
      ->add_option("--frames", options->frames,
                   "Frames first:last to render [those of the scene's animation]")
      ->group("Animation");
  command
      ->add_option("--fps", options->framesPerSecond,
                   "Frames per second: frame f shows second f / fps [the scene's]")
      ->check(CLI::Range(1e-3, 1e4))
      ->group("Animation");
  command->add_flag("--resume", options->resume, "Skip frames whose pictures are complete")
      ->group("Animation");
  addCompareOption(*command, options->compareTo);
  command
      ->add_option("--sheet", options->sheet,
                   "PNG with the pictures of all methods compared and their errors side by side")
      ->group("Output");
  addGeneralOptions(*command, options->general);
  command->callback([options] { render(*options); });
}

}  // namespace haarlight
