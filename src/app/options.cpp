#include "app/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "app/shadow_options.h"
#include "base/error.h"
#include "base/file.h"
#include "light/sky_model.h"
#include "mesh/text_lines.h"
#include "scene/names.h"
#include "scene/scene_fields.h"
#include "scene/scene_file.h"
#include "spheres/sphere_set.h"
#include "transfer/diffuse_transfer.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

/// An object standing on the ground plane, two units large, with the ground around it in view.
SceneDescription sceneAroundMesh(const std::string& mesh) {
  ObjectDescription object;
  object.name = defaultObjectName(mesh);
  object.mesh = mesh;
  object.transform.fit = 2.0;
  object.transform.rest = Rest::Ground;
  SceneDescription scene;
  scene.objects.push_back(object);
  scene.receiver = ReceiverDescription{};
  scene.receiver->size = {9, 9};
  scene.camera.position = {2.2, 3.3, 5.4};
  scene.camera.target = {0, 0.7, 0};
  scene.camera.verticalFieldOfViewDegrees = 34;
  return scene;
}

CLI::Validator notEmpty() {
  return {[](const std::string& value) { return value.empty() ? "takes no empty text" : ""; }, ""};
}

/// Adds options whose value is a text.
struct TextOptions {
  CLI::App& command;

  CLI::Option* operator()(const char* name, std::string& value, const char* help,
                          const char* group) const {
    return command.add_option(name, value, help)->group(group)->check(notEmpty());
  }
};

void applySky(const SceneOptions& options, LightDescription& light) {
  if (options.sun.empty() && !options.sunDisc) return;
  const char* option = options.sun.empty() ? "--sun-disc" : "--sun";
  if (!findSky(light.source))
    throw InputError(
        fmt::format("{} is for skies such as builtin:cie-clear, not for {}", option, light.source));
  if (!light.sky) light.sky.emplace();
  if (!options.sun.empty()) parseSun(options.sun, *light.sky);
  if (options.sunDisc)
    light.sky->sunDisc = withinRange(*options.sunDisc, sunDiscRange, "--sun-disc");
}

void applyLight(const SceneOptions& options, LightDescription& light) {
  if (!options.light.empty()) {
    light.source = options.light;
    light.layout = "auto";
  }
  if (!options.layout.empty()) light.layout = options.layout;
  if (options.lightRotation)
    light.rotateDegrees = withinRange(*options.lightRotation, angleRange, "--light-rotate");
  if (options.lightScale)
    light.scale = withinRange(*options.lightScale, radianceRange, "--light-scale");
  applySky(options, light);
}

void applyShading(const SceneOptions& options, ShadingDescription& shading) {
  if (!options.method.empty()) shading.method = choiceOf(shadingMethodNames, options.method);
  if (!options.engine.empty()) shading.engine = choiceOf(engineChoiceNames, options.engine);
  if (!options.visibility.empty())
    shading.visibility = choiceOf(visibilityKindNames, options.visibility);
  if (options.terms) shading.terms = *options.terms;
  if (options.levels) shading.levels = *options.levels;
  if (options.order) shading.order = *options.order;
  if (!options.per.empty()) shading.per = choiceOf(shadedPerNames, options.per);
  if (!options.shadowDetail.empty()) parseDetail(options.shadowDetail);  // or throw at once
}

/// Why `auto` came down to the slowest engine.
std::string referenceWarning() {
  const std::string advice = openClAdvice();
  return (advice.empty() ? "no device passes the self test" : advice) +
         "; using the scalar reference engine";
}

}  // namespace

void addGeneralOptions(CLI::App& command, GeneralOptions& options) {
  command.add_flag("--json", options.json, "Print the results as JSON")->group("Output");
  command.add_flag("--quiet", options.quiet, "No messages and no progress bar")->group("Output");
  command.add_option("--threads", options.threads, "Threads on the host, 0: one per processor")
      ->group("Computation")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

CLI::Option* addSeedOption(CLI::App& command, std::uint64_t& seed, const std::string& help) {
  const CLI::Validator withoutSign(
      [](const std::string& text) { return text.starts_with('-') ? "must not be negative" : ""; },
      "");
  return command.add_option("--seed", seed, help)->check(withoutSign)->capture_default_str();
}

void addSceneContentOptions(CLI::App& command, SceneOptions& options) {
  command
      .add_option("SCENE", options.scene,
                  fmt::format("Scene file, or {}", fmt::join(builtinScenes, ", ")))
      ->check(notEmpty());
  const TextOptions text{command};
  text("--mesh", options.mesh, "Instead of a scene: a mesh on the ground plane", "Scene");
  text("--light", options.light,
       "EXR or Radiance HDR image, builtin:lamps, builtin:sky, builtin:constant, or a sky such as "
       "builtin:cie-clear or builtin:iso-sky-7",
       "Scene");
  text("--layout", options.layout, "How the light's image covers the sphere [by its shape]",
       "Scene")
      ->check(CLI::IsMember(std::vector<std::string>(lightLayouts.begin(), lightLayouts.end())));
  command.add_option("--light-rotate", options.lightRotation, "Degrees about +Y [0]")
      ->group("Scene");
  command.add_option("--light-scale", options.lightScale, "Factor on the radiance [1]")
      ->group("Scene");
  text("--sun", options.sun,
       "Of a sky: AZIMUTH,ELEVATION in degrees, from +Z towards +X and from the horizon [40,45]",
       "Scene");
  command
      .add_option("--sun-disc", options.sunDisc,
                  "Of a sky: the sun's disc, 1: as bright as on a clear day [0]")
      ->group("Scene");
}

void addSceneOptions(CLI::App& command, SceneOptions& options) {
  addSceneContentOptions(command, options);
  addShadingOptions(command, options);
  const TextOptions text{command};
  text("--method", options.method,
       "haar, pixel (all texels), pixel-mesh (rays), shexp (spherical harmonics) or sh "
       "(precomputed transfer) [haar]",
       "Computation")
      ->check(CLI::IsMember(namesOf(shadingMethodNames)));
}

void addShadingOptions(CLI::App& command, SceneOptions& options) {
  const TextOptions text{command};
  command.add_option("--spheres", options.spheres, "Spheres fitted to each object [64]")
      ->group("Scene")
      ->check(CLI::Range(1, 4096));
  text("--objective", options.objective,
       "Of that fit: least error of the shadow, or cover (every point in a sphere) [shadow]",
       "Scene")
      ->check(CLI::IsMember(namesOf(fitObjectiveNames)));
  command.add_option("--terms", options.terms, "Light wavelets kept, 0 to 6144 [200]")
      ->group("Computation")
      ->check(CLI::Range(0, maximumTerms));
  command.add_option("--levels", options.levels, "Levels of visibility, 1 or 2 [2]")
      ->group("Computation")
      ->check(CLI::Range(1, 2));
  command
      .add_option("--order", options.order,
                  "Bands of spherical harmonics: of shexp, 4 to 6 [4]; of sh, 1 to 20 [5, or the "
                  "files']")
      ->group("Computation")
      ->check(CLI::Range(1, maximumTransferOrder));
  text("--per", options.per,
       "Of sh: vertex (radiance interpolated) or pixel (transfer interpolated) [vertex]",
       "Computation")
      ->check(CLI::IsMember(namesOf(shadedPerNames)));
  command
      .add_option("--transfer", options.transfer,
                  "Of sh: transfer by haarlight prt for an object's mesh or the scene; may be "
                  "repeated")
      ->allow_extra_args(false)
      ->group("Computation")
      ->check(notEmpty());
  text("--visibility", options.visibility,
       "Of spheres, for haar and pixel: exact, or the paper's table (faster) [exact]",
       "Computation")
      ->check(CLI::IsMember(namesOf(visibilityKindNames)));
  text(
      "--detail", options.shadowDetail,
      "Of hard shadows: the largest edge of the smallest cells in world units, or depth=N [a 512th "
      "of the scene]",
      "Computation");
  text("--engine", options.engine, "auto, reference, opencl, cuda or cuda-host [auto]",
       "Computation")
      ->check(CLI::IsMember(namesOf(engineChoiceNames)));
  text("--device", options.device, "Device of the engine: part of its name, or its index",
       "Computation");
}

int shexpOrder(const ShadingDescription& shading) {
  constexpr int smallest = 4, largest = 6;
  const int order = shading.order.value_or(smallest);
  if (order < smallest || order > largest)
    throw InputError(fmt::format("the method shexp takes an order from {} to {}, not {}", smallest,
                                 largest, order));
  return order;
}

void requireOrder(const std::vector<std::string>& methods, const ShadingDescription& shading) {
  if (std::ranges::count(methods, "shexp") > 0) shexpOrder(shading);
}

SceneDescription describeScene(const SceneOptions& options) {
  if (!options.scene.empty() && !options.mesh.empty())
    throw InputError("give a scene or --mesh, not both");
  const std::string extension = fs::path(options.scene).extension().string();
  for (const char* meshExtension : {".obj", ".ply", ".off", ".stl"})
    if (extension == meshExtension)
      throw InputError(options.scene + " is a mesh, not a scene file: give it with --mesh");
  SceneDescription scene =
      !options.mesh.empty() ? sceneAroundMesh(options.mesh)
                            : readScene(options.scene.empty() ? "builtin:default" : options.scene);
  applyLight(options, scene.light);
  applyShading(options, scene.shading);
  if (options.spheres)
    for (ObjectDescription& object : scene.objects) object.spheres = *options.spheres;
  if (!options.objective.empty())
    for (ObjectDescription& object : scene.objects)
      object.objective = choiceOf(fitObjectiveNames, options.objective);
  if (scene.shading.method == ShadingMethod::Shexp) shexpOrder(scene.shading);
  if (!options.device.empty() && scene.shading.engine == EngineChoice::Reference)
    throw InputError(
        "--device is for the engines opencl and cuda, not for reference; leave one of them out");
  return scene;
}

std::shared_ptr<const SphereTable> openSphereTable(const SceneDescription& scene,
                                                   Console& console) {
  if (scene.shading.visibility == VisibilityKind::exact) return nullptr;
  const auto start = std::chrono::steady_clock::now();
  const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  console.message(fmt::format("sphere table ready in {:.2f} s", seconds.count()));
  return table;
}

std::shared_ptr<Engine> openEngine(const SceneOptions& options, const SceneDescription& scene,
                                   std::shared_ptr<const SphereTable> table, Console& console) {
  EngineOptions engineOptions;
  engineOptions.engine = nameOf(engineChoiceNames, scene.shading.engine);
  engineOptions.device = options.device;
  engineOptions.onRefusal = [&](const std::string& reason) {
    console.warning(reason + "; trying the next one");
  };
  engineOptions.onWarning = [&](const std::string& warning) { console.warning(warning); };
  std::shared_ptr<Engine> engine = makeEngine(engineOptions, std::move(table));
  if (engineOptions.engine == "auto" && engine->name() == "reference")
    console.warning(referenceWarning());
  if (engine->preparationSeconds() > 0)
    console.message(fmt::format("{}: kernels ready in {:.2f} s", engine->deviceName(),
                                engine->preparationSeconds()));
  return engine;
}

void parseSun(const std::string& text, SkySettings& sky) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view view = text, azimuth = view.substr(0, comma),
                         elevation = view.substr(std::min(comma + 1, text.size()));
  if (!parseNumber(azimuth, sky.sunAzimuthDegrees) ||
      !parseNumber(elevation, sky.sunElevationDegrees))
    throw InputError("--sun takes AZIMUTH,ELEVATION in degrees such as 120,45, not '" + text + "'");
  withinRange(sky.sunAzimuthDegrees, angleRange, "--sun's azimuth");
  withinRange(sky.sunElevationDegrees, elevationRange, "--sun's elevation");
}

/// CLI::Range lets NaN through.
double withinRange(double value, const Range& range, const std::string& option) {
  if (value >= range.minimum && value <= range.maximum) return value;
  throw InputError(fmt::format("{} takes a number from {} to {}, not {}", option, range.minimum,
                               range.maximum, value));
}

glm::ivec2 parseSize(const std::string& text, const std::string& option) {
  glm::ivec2 size(0);
  const char* end = text.data() + text.size();
  const auto [afterWidth, widthError] = std::from_chars(text.data(), end, size.x);
  if (widthError == std::errc() && afterWidth != end && *afterWidth == 'x') {
    const auto [afterHeight, heightError] = std::from_chars(afterWidth + 1, end, size.y);
    if (heightError == std::errc() && afterHeight == end && size.x > 0 && size.y > 0) {
      if (std::int64_t(size.x) * size.y <= maximumPixelCount) return size;
      throw InputError(
          fmt::format("{} {}: at most {} pixels in all", option, text, maximumPixelCount));
    }
  }
  throw InputError(fmt::format("{} takes WIDTHxHEIGHT such as 960x540, not '{}'", option, text));
}

glm::ivec2 parseReceiverSize(const std::string& text) {
  const glm::ivec2 size = parseSize(text, "--size");
  if (std::max(size.x, size.y) > 4096) throw InputError("--size " + text + ": at most 4096 a side");
  return size;
}

void checkTarget(const fs::path& target, const std::vector<std::string>& extensions) {
  if (std::ranges::find(extensions, target.extension().string()) == extensions.end())
    throw InputError(fmt::format("cannot write {}: its name must end in {}", target.string(),
                                 fmt::join(extensions, " or ")));
  std::error_code error;
  if (fs::is_directory(target, error))
    throw InputError(fmt::format("cannot write {}: it is a folder", target.string()));
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    throw InputError(
        fmt::format("cannot write {}: there is no folder {}", target.string(), folder.string()));
  if (access(folder.c_str(), W_OK) != 0)
    throw InputError(fmt::format("cannot write {}: the folder {} is not writable", target.string(),
                                 folder.string()));
}

}  // namespace haarlight
