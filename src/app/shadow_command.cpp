#include <fmt/format.h>

#include <cmath>

#include "app/commands.h"
#include "app/options.h"
#include "app/picture_options.h"
#include "app/shadow_options.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/peak_memory.h"
#include "hard_shadow/shadow_comparison.h"
#include "image/tonemap.h"
#include "image/write_image.h"
#include "render/moving_scene.h"
#include "render/render_image.h"
#include "render/scene_participants.h"
#include "report/shadow_sheet.h"
#include "scene/keyframes.h"

namespace haarlight {

namespace {

struct ShadowOptions {
  GeneralOptions general;
  SceneOptions scene;
  PunctualLightOptions lights;
  PictureOptions picture;
  std::vector<std::string> details;
  int interior = 0;
  std::string method = "octree";
  std::vector<std::string> compareTo;
  double seconds = 0;
  bool plain = false;
  std::vector<std::string> outputs;
  std::string sheet;
};

const std::vector<std::string> allMethods{"octree", "classic", "classic-triangles", "exact"};

SceneDescription describe(const ShadowOptions& options) {
  SceneOptions content = options.scene;
  if (content.scene.empty() && content.mesh.empty()) content.scene = "builtin:lamp-knot";
  SceneDescription scene = describeScene(content);
  PunctualLightOptions lights = options.lights;
  if (!content.mesh.empty() && lights.pointLights.empty() && lights.directionalLights.empty())
    lights.pointLights = {"2.5,5,2"};
  applyPunctualLights(lights, scene);
  applyPictureOptions(options.picture, scene.image);
  if (scene.pointLights.empty() && scene.directionalLights.empty())
    throw InputError(
        "the scene has no light with hard shadows: give it pointLights or directionalLights, or "
        "try --point-light X,Y,Z or --directional-light X,Y,Z");
  return scene;
}

void checkOptions(const ShadowOptions& options) {
  for (const std::string& detail : options.details) parseDetail(detail);
  for (const std::string& output : options.outputs) checkTarget(output, {".png", ".exr"});
  if (!options.sheet.empty()) checkTarget(options.sheet, {".png"});
  if (!std::isfinite(options.seconds)) throw InputError("--seconds takes a number");
  const bool hasOctree =
      options.method == "octree" || std::ranges::count(options.compareTo, "octree") > 0;
  if (!hasOctree && (!options.details.empty() || options.interior > 0))
    throw InputError("--detail and --interior are for octrees; add --compare-to octree");
}

/// The method asked for comes first.
std::vector<std::string> methodsOf(const ShadowOptions& options) {
  std::vector<std::string> methods{options.method};
  for (const std::string& method : options.compareTo)
    if (std::ranges::count(methods, method) == 0) methods.push_back(method);
  return methods;
}

/// Those asked for, or the scene's.
std::vector<LevelOfDetail> detailsOf(const ShadowOptions& options,
                                     const ShadingDescription& shading, const AxisBox& scene) {
  std::vector<std::string> texts = options.details;
  if (texts.empty()) texts.emplace_back();
  std::vector<LevelOfDetail> details;
  for (const std::string& text : texts) {
    details.push_back(detailOf(text, shading, scene));
    details.back().interior = options.interior;
    checkDetail(details.back());
  }
  return details;
}

void addRuns(const ShadowOptions& options, const std::vector<LevelOfDetail>& details,
             const SceneParticipants& scene, std::span<const ShadowLight> lights,
             ShadowComparison& comparison) {
  for (const std::string& method : methodsOf(options)) {
    if (method == "classic")
      comparison.add(method, makeClassicShadows(scene.asPolygons(), lights));
    else if (method == "classic-triangles")
      comparison.add(method, makeClassicShadows(scene.asPolygons(), lights,
                                                ClassicVolume::Sides::ofEachTriangle));
    else if (method == "exact")
      comparison.add(method, makeExactShadows(scene.participants(), lights));
    else
      for (const LevelOfDetail& detail : details)
        comparison.add("octree " + textOf(detail),
                       makeOctreeShadows(scene.participants(), lights, detail));
  }
}

nlohmann::ordered_json describeRun(const ShadowRun& run, bool hasReference) {
  nlohmann::ordered_json figures{{"method", run.label}};
  figures.update(run.method->figures());
  if (!hasReference || run.method->name() == "exact") return figures;
  figures["difference"] = {{"shadow_rays", run.difference.inShadow},
                           {"missing", run.difference.missing},
                           {"extra", run.difference.extra},
                           {"area_error_percent", 100 * run.difference.areaError()},
                           {"wrong_percent", 100 * run.difference.wrongPart()}};
  return figures;
}

void writeOutputs(const ShadowOptions& options, const Image& picture, float stops) {
  const ImageAttributes attributes{{"method", "hard shadows, " + options.method}};
  for (const std::string& output : options.outputs)
    if (output.ends_with(".exr"))
      writeExr(output, {{"", picture}}, attributes);
    else
      writePng(output, tonemap(picture, stops));
}

void shadow(const ShadowOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  checkOptions(options);
  const SceneDescription description = describe(options);
  const ImageDescription& image = description.image;
  MovingScene moving(description, console.progress(), SceneParts::hardShadows);
  moving.show(options.seconds);
  for (const std::string& warning : moving.scene().warnings) console.warning(warning);

  const SceneParticipants scene(moving.scene());
  const int raysPerSide = raysPerPixelSide(image);
  const Camera camera(cameraAt(description.camera, options.seconds), image.width, image.height);
  const SurfaceViewer viewer(scene.participants(), camera, image.width, image.height, raysPerSide);
  const std::vector<PunctualLight>& lights = moving.scene().punctualLights;
  ShadowComparison comparison(viewer, {scene.albedos(), lights, scene.bounds(), image.width,
                                       image.height, raysPerSide, !options.plain});
  std::vector<ShadowLight> places;
  for (const PunctualLight& light : lights) places.push_back(light.light);
  addRuns(options, detailsOf(options, description.shading, scene.bounds()), scene, places,
          comparison);
  const Progress progress = console.progress();
  comparison.run([&](double finished) {
    if (progress) progress("drawing shadows", finished);
  });

  const Image& picture = comparison.runs().front().picture.image();
  const float stops = image.exposure ? float(*image.exposure) : automaticExposure(picture);
  writeOutputs(options, picture, stops);
  nlohmann::ordered_json results;
  if (!options.outputs.empty()) results["picture"] = options.outputs.front();
  results["size"] = fmt::format("{}x{}", image.width, image.height);
  results["camera_rays_per_pixel"] = raysPerSide * raysPerSide;
  results["objects"] = scene.participants().size();
  results["lights"] = lights.size();
  results["exposure_stops"] = stops;
  results["camera_seconds"] = comparison.viewSeconds();
  results["run"] = nlohmann::ordered_json::array();
  for (const ShadowRun& run : comparison.runs())
    results["run"].push_back(describeRun(run, comparison.hasReference()));
  if (!options.sheet.empty()) {
    writePng(options.sheet, shadowSheet(comparison, stops));
    results["sheet"] = options.sheet;
  }
  results["peak_memory_mib"] = peakMemoryMebibytes();
  console.results(results);
}

void addMethodOptions(CLI::App& command, ShadowOptions& options) {
  command
      .add_option("--detail", options.details,
                  "Of octrees: the largest edge of the smallest cells in world units, or depth=N "
                  "[the scene's, or a 512th of the scene]; may be repeated")
      ->allow_extra_args(false)
      ->group("Computation");
  command
      .add_option("--interior", options.interior,
                  "Of octrees: depth to which cells that are all in shadow or light are divided")
      ->group("Computation")
      ->check(CLI::Range(0, deepestCell))
      ->capture_default_str();
  command
      .add_option("--method", options.method,
                  "octree, classic (shadow volumes of silhouettes), classic-triangles (of each "
                  "triangle alone) or exact (a ray per camera ray)")
      ->group("Computation")
      ->check(CLI::IsMember(allMethods))
      ->capture_default_str();
  command
      .add_option("--compare-to", options.compareTo,
                  "Compute it again by this method; exact also tells the others' errors; may be "
                  "repeated")
      ->allow_extra_args(false)
      ->group("Computation")
      ->check(CLI::IsMember(allMethods));
}

}  // namespace

void addShadowCommand(CLI::App& app) {
  const auto options = std::make_shared<ShadowOptions>();
  CLI::App* command = app.add_subcommand(
      "shadow", "Draw hard shadows of point and directional lights at a level of detail");
  command->footer(
      "Examples:\n"
      "  haarlight shadow --detail 0.02 -o knot.png\n"
      "  haarlight shadow builtin:cone-and-sphere --detail depth=10 --compare-to exact -o "
      "cone.png\n"
      "  haarlight shadow --mesh bunny.obj --directional-light 1,2,0.5 -o bunny.png\n"
      "  haarlight shadow scene.json --method classic --compare-to octree --detail 0.1 \\\n"
      "      --detail 0.001 --compare-to exact --sheet levels.png");
  command->add_option("SCENE", options->scene.scene,
                      "Scene file with point or directional lights, or a built-in scene "
                      "[builtin:lamp-knot]");
  command
      ->add_option("--mesh", options->scene.mesh,
                   "Instead of a scene: a mesh on the ground plane, under a point light")
      ->group("Scene");
  addPunctualLightOptions(*command, options->lights);
  command->add_option("--seconds", options->seconds, "Of a scene that moves: the second to show")
      ->group("Scene")
      ->capture_default_str();
  addMethodOptions(*command, *options);
  command
      ->add_option("-o,--output", options->outputs,
                   "Picture to write: .png (sRGB) or .exr (linear float32); may be repeated")
      ->allow_extra_args(false)
      ->group("Output");
  command
      ->add_option("--sheet", options->sheet,
                   "PNG with the pictures of all methods and details, and their errors")
      ->group("Output");
  command->add_flag("--plain", options->plain, "Do not draw the cells of octrees")->group("Output");
  addPictureOptions(*command, options->picture, "960x540");
  addGeneralOptions(*command, options->general);
  command->callback([options] { shadow(*options); });
}

}  // namespace haarlight
