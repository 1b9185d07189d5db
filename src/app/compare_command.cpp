#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/picture_options.h"
#include "app/shading_setup.h"
#include "base/error.h"
#include "base/parallel.h"
#include "image/tonemap.h"
#include "render/render_image.h"
#include "report/method_sheet.h"
#include "scene/names.h"

namespace haarlight {

namespace {

struct CompareOptions {
  GeneralOptions general;
  SceneOptions scene;
  PictureOptions picture;
  std::vector<std::string> methods, references;
  std::string sheet;
};

/// The exact methods, then the approximations.
const std::vector<std::string> allMethods{"pixel-mesh", "pixel", "haar", "shexp", "sh"};

constexpr glm::ivec2 defaultSize{480, 270};

SceneDescription describe(const CompareOptions& options, const std::vector<std::string>& methods) {
  SceneDescription scene = describeScene(options.scene);
  requireOrder(methods, scene.shading);
  scene.image.width = defaultSize.x;
  scene.image.height = defaultSize.y;
  applyPictureOptions(options.picture, scene.image);
  return scene;
}

/// Those that are asked for, in the order of allMethods.
std::vector<std::string> methodsOf(const CompareOptions& options) {
  std::vector<std::string> methods;
  for (const std::string& name : allMethods)
    if (options.methods.empty() || std::ranges::count(options.methods, name) > 0)
      methods.push_back(name);
  return methods;
}

/// Transfer is for meshes: unless it is asked for, `sh` is left out of a scene with solids.
void leaveOutTransfer(const CompareOptions& options, const SceneDescription& scene,
                      std::vector<std::string>& methods, Console& console) {
  const bool hasSolids = std::ranges::any_of(
      scene.objects, [](const ObjectDescription& object) { return object.solid.has_value(); });
  if (!hasSolids || !options.methods.empty()) return;
  std::erase(methods, "sh");
  console.warning("the method sh is left out, for it has no transfer of solids");
}

/// Places of the references among the methods; without --reference the exact ones that are there,
/// or the first.
std::vector<std::size_t> referencesOf(const CompareOptions& options,
                                      const std::vector<std::string>& methods) {
  std::vector<std::size_t> places;
  for (const std::string& name : options.references) {
    const auto found = std::ranges::find(methods, name);
    if (found == methods.end())
      throw InputError("--reference " + name + " is not among the methods compared; add --method " +
                       name);
    places.push_back(std::size_t(found - methods.begin()));
  }
  if (!places.empty()) return places;
  for (std::size_t i = 0; i < methods.size(); ++i)
    if (methods[i].starts_with("pixel")) places.push_back(i);
  if (places.empty()) places.push_back(0);
  return places;
}

/// What all methods made of one view.
struct Comparison {
  std::vector<MethodPicture> pictures;
  std::vector<std::uint8_t> surfaceMask;
  nlohmann::ordered_json summaries = nlohmann::ordered_json::array();
};

/// "200 terms, 0.6 s": what cuts the method short, and its time.
std::string noteOf(const nlohmann::ordered_json& summary, double seconds) {
  std::string cut;
  if (summary.contains("terms")) cut = fmt::format("{} terms, ", summary["terms"].get<int>());
  if (summary.contains("order")) cut = fmt::format("order {}, ", summary["order"].get<int>());
  return fmt::format("{}{:.2f} s", cut, seconds);
}

Comparison renderAll(ShadingSetup& setup, const std::vector<std::string>& methods) {
  const SceneDescription& scene = setup.description();
  const ScreenSampler sampler(setup.scene(), cameraAt(scene.camera, 0), scene.image);
  const auto overview = sampler.overview();
  Comparison comparison;
  for (const std::string& name : methods) {
    const auto method = setup.method(choiceOf(shadingMethodNames, name), overview, true);
    RenderedImage picture = sampler.render(*method, setup.console().progress());
    const double seconds = method->times().total;
    comparison.surfaceMask = std::move(picture.surfaceMask);
    auto summary = setup.summary(*method);
    summary["seconds"] = seconds;
    comparison.pictures.push_back({name, noteOf(summary, seconds), std::move(picture.radiance)});
    comparison.summaries.push_back(std::move(summary));
  }
  return comparison;
}

std::vector<ErrorRow> addErrors(Comparison& comparison,
                                const std::vector<std::size_t>& references) {
  std::vector<ErrorRow> rows;
  for (const std::size_t reference : references) {
    rows.push_back(errorsAgainst(comparison.pictures, reference, comparison.surfaceMask));
    for (std::size_t i = 0; i < comparison.pictures.size(); ++i)
      if (i != reference)
        comparison.summaries[i]["error"].push_back(
            describeError(rows.back().errors[i], comparison.pictures[reference].method));
  }
  return rows;
}

void compare(const CompareOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  if (!options.sheet.empty()) checkTarget(options.sheet, {".png"});
  auto methods = methodsOf(options);
  SceneDescription description = describe(options, methods);
  leaveOutTransfer(options, description, methods, console);
  const auto references = referencesOf(options, methods);
  ShadingSetup setup(options.scene, std::move(description), console);
  Comparison comparison = renderAll(setup, methods);
  const auto rows = addErrors(comparison, references);
  const ImageDescription& image = setup.description().image;
  const float stops = image.exposure ? float(*image.exposure)
                                     : automaticExposure(comparison.pictures.front().radiance);
  nlohmann::ordered_json results{{"size", fmt::format("{}x{}", image.width, image.height)},
                                 {"exposure_stops", stops},
                                 {"picture", comparison.summaries}};
  if (!options.sheet.empty()) {
    writePng(options.sheet, methodSheet(comparison.pictures, rows, stops));
    results["sheet"] = options.sheet;
  }
  console.results(results);
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      app.add_subcommand("compare", "Render one view by every method, side by side with errors");
  command->footer(
      "Examples:\n"
      "  haarlight compare -o compare.png\n"
      "  haarlight compare --mesh bunny.obj --light grace.hdr -o grace.png\n"
      "  haarlight compare scene.json --method pixel --method shexp --order 6 -o shexp.png");
  addSceneContentOptions(*command, options->scene);
  addShadingOptions(*command, options->scene);
  command->add_option("-o,--output", options->sheet, "Sheet to write (.png)")->group("Output");
  addPictureOptions(*command, options->picture, "480x270");
  const auto methodOption = [&](const char* name, std::vector<std::string>& list,
                                const char* help) {
    command->add_option(name, list, help)
        ->allow_extra_args(false)
        ->group("Computation")
        ->check(CLI::IsMember(allMethods));
  };
  methodOption("--method", options->methods, "Only this method; may be repeated");
  methodOption("--reference", options->references,
               "Show errors against this method [pixel-mesh and pixel]; may be repeated");
  addGeneralOptions(*command, options->general);
  command->callback([options] { compare(*options); });
}

}  // namespace haarlight
