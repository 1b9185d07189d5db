#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "app/commands.h"
#include "app/frame_rate.h"
#include "app/shading_setup.h"
#include "base/error.h"
#include "base/parallel.h"
#include "image/tonemap.h"
#include "render/render_image.h"
#include "scene/names.h"

namespace haarlight {

namespace {

struct RenderOptions {
  GeneralOptions general;
  SceneOptions scene;
  std::vector<std::string> outputs;
  std::string size;
  std::optional<int> samples;
  std::string exposure;
  std::string compareTo;
  bool frameRate = false;
};

void applyExposure(const std::string& text, ImageDescription& image) {
  if (text.empty()) return;
  image.exposure.reset();
  if (text == "auto") return;
  std::size_t used = 0;
  try {
    image.exposure = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || !(std::abs(*image.exposure) <= 64))
    throw InputError("--exposure takes a number of stops from -64 to 64 or auto, not '" + text +
                     "'");
}

SceneDescription describe(const RenderOptions& options) {
  SceneDescription scene = describeScene(options.scene);
  if (!options.size.empty()) {
    const glm::ivec2 size = parseSize(options.size, "--size");
    scene.image.width = size.x;
    scene.image.height = size.y;
  }
  if (options.samples) scene.image.samplesPerPixel = *options.samples;
  applyExposure(options.exposure, scene.image);
  return scene;
}

/// Writes the picture to every target and returns the exposure of the PNGs.
float writeOutputs(const RenderOptions& options, const RenderedImage& picture,
                   const ImageDescription& image, const ImageAttributes& attributes) {
  const float stops = image.exposure ? float(*image.exposure) : automaticExposure(picture.radiance);
  for (const std::string& output : options.outputs) {
    if (std::filesystem::path(output).extension() == ".exr")
      writeExr(output, {{"", picture.radiance}, {"albedo", picture.albedo}, {"N", picture.normal}},
               attributes);
    else
      writePng(output, tonemap(picture.radiance, stops));
  }
  return stops;
}

/// The paper's frame: all samples of the receiver plane.
nlohmann::ordered_json planeFrameRate(ShadingSetup& setup) {
  const auto samples = planeSamples(*setup.scene().receiver);
  const auto method = setup.method(setup.description().shading.method, samples, false);
  return measureFrameRate(*method, samples);
}

nlohmann::ordered_json compare(ShadingSetup& setup, const ScreenSampler& sampler,
                               const RenderedImage& picture, const std::string& methodName) {
  const auto reference =
      setup.method(choiceOf(shadingMethodNames, methodName), sampler.overview(), true);
  const RenderedImage other = sampler.render(*reference, setup.console().progress());
  auto figures = describeError(compareImages(picture.radiance, other.radiance, picture.surfaceMask),
                               methodName);
  figures["seconds"] = reference->times().total;
  return figures;
}

void render(const RenderOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  for (const std::string& output : options.outputs) checkTarget(output, {".png", ".exr"});
  ShadingSetup setup(options.scene, describe(options), console);
  const SceneDescription& scene = setup.description();
  if (options.frameRate && !scene.receiver)
    throw InputError("--frame-rate needs a receiver plane in the scene");

  const auto start = std::chrono::steady_clock::now();
  const ScreenSampler sampler(setup.scene(), scene.camera, scene.image);
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
  if (options.frameRate) results["plane_frame"] = planeFrameRate(setup);
  if (!options.compareTo.empty())
    results["comparison"] = compare(setup, sampler, picture, options.compareTo);
  console.results(results);
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render a picture of a scene");
  command->footer(
      "Examples:\n"
      "  haarlight render -o picture.png\n"
      "  haarlight render --mesh bunny.obj --light grace.hdr --spheres 64 -o bunny.png\n"
      "  haarlight render scene.json --method pixel-mesh -o reference.exr");
  addSceneOptions(*command, options->scene);
  command
      ->add_option("-o,--output", options->outputs,
                   "Picture to write: .png (sRGB) or .exr (linear float32); may be repeated")
      ->required()
      ->group("Output");
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels [960x540]")->group("Output");
  command->add_option("--samples", options->samples, "Camera rays per pixel [4]")
      ->group("Computation")
      ->check(CLI::Range(1, 1024));
  command->add_option("--exposure", options->exposure, "Stops, or auto, for PNG [auto]")
      ->group("Output");
  command
      ->add_flag("--frame-rate", options->frameRate,
                 "Also measure frames per second of the receiver plane's samples")
      ->group("Computation");
  addCompareOption(*command, options->compareTo);
  addGeneralOptions(*command, options->general);
  command->callback([options] { render(*options); });
}

}  // namespace haarlight
