#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/transfer_json.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "mesh/mesh_file.h"
#include "mesh/text_lines.h"
#include "render/scene_transfer.h"
#include "scene/names.h"
#include "scene/scene_file.h"
#include "transfer/transfer_file.h"

namespace haarlight {

namespace {

struct PrtOptions {
  GeneralOptions general;
  std::string mesh;
  std::string output;
  std::optional<std::string> albedo;
  bool unshadowed = false;
  bool bouncesGiven = false;
  TransferOptions transfer;
};

/// One number for grey, or three with commas.
glm::vec3 parseAlbedo(const std::string& text) {
  glm::vec3 albedo(0);
  int count = 0;
  for (std::size_t begin = 0; begin <= text.size() && count < 4; ++count) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    float value = -1;
    parseNumber(std::string_view(text).substr(begin, end - begin), value);
    if (!(value >= 0 && value <= 1)) count = 4;
    if (count < 3) albedo[count] = value;
    begin = end + 1;
  }
  if (count == 1) return glm::vec3(albedo.x);
  if (count == 3) return albedo;
  throw InputError("--albedo takes R,G,B or one number for grey, each from 0 to 1, not '" + text +
                   "'");
}

bool isScene(const std::string& name) {
  return name.ends_with(".json") || std::ranges::find(builtinScenes, name) != builtinScenes.end();
}

/// A mesh, or all of a scene as it is at second 0, which needs no more than one sphere an object.
LoadedMesh load(const std::string& name, Console& console) {
  if (!isScene(name)) return loadMeshOrBuiltin(name);
  SceneDescription description = readScene(name);
  for (ObjectDescription& object : description.objects) object.spheres = 1;
  const Scene scene = loadScene(description, console.progress());
  return {wholeSceneMesh(scene), {}, {}, scene.warnings};
}

TransferOptions transferOptions(const PrtOptions& options) {
  TransferOptions transfer = options.transfer;
  if (isScene(options.mesh)) {
    if (options.albedo || options.bouncesGiven)
      throw InputError(
          "the transfer of a scene has shadows alone, and the scene's albedo: leave --bounces and "
          "--albedo out");
    transfer.albedo = glm::vec3(1);
    transfer.bounces = 0;
  }
  if (options.albedo) transfer.albedo = parseAlbedo(*options.albedo);
  if (options.unshadowed)
    transfer.kind = TransferKind::unshadowed;
  else if (transfer.bounces == 0)
    transfer.kind = TransferKind::shadowed;
  return transfer;
}

nlohmann::ordered_json resultsJson(const PrtOptions& options, const TriangleMesh& mesh,
                                   const TransferResult& result) {
  nlohmann::ordered_json results{{"transfer", options.output}};
  results.update(transferJson(result.transfer));
  results["triangles"] = mesh.triangles.size();
  results["rays"] = std::uint64_t(result.transfer.raysPerVertex) * result.transfer.vertices;
  results["blocked_part"] = result.blockedPart;
  for (const glm::vec3& bounce : result.energyByBounce)
    results["energy_by_bounce"].push_back(colorJson(bounce));
  return results;
}

void prt(const PrtOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  checkTarget(options.output, {".prt"});
  const TransferOptions transfer = transferOptions(options);
  const InterruptWatch interrupt;
  Stopwatch watch;
  const LoadedMesh loaded = load(options.mesh, console);
  for (const std::string& warning : loaded.warnings) console.warning(options.mesh + ": " + warning);
  const double loading = watch.lap();
  const TransferResult result = computeTransfer(
      loaded.mesh, transfer, {console.progress(), [&] { return interrupt.interrupted(); }});
  watch.lap();
  writeTransfer(options.output, result.transfer);
  const double writing = watch.lap();
  nlohmann::ordered_json results = resultsJson(options, loaded.mesh, result);
  results["seconds"] = {{"loading", loading},
                        {"rays", result.raySeconds},
                        {"bounces", result.bounceSeconds},
                        {"writing", writing},
                        {"total", watch.total()}};
  console.results(results);
}

}  // namespace

void addPrtCommand(CLI::App& app) {
  const auto options = std::make_shared<PrtOptions>();
  CLI::App* command =
      app.add_subcommand("prt", "Precompute how a mesh's vertices turn light into radiance");
  command->footer(
      "Examples:\n"
      "  haarlight prt bunny.obj -o transfer.prt --order 5 --bounces 2\n"
      "  haarlight prt bunny.obj -o transfer.prt --albedo 0.8,0.5,0.3 --rays 4096\n"
      "  haarlight prt scene.json -o scene.prt --order 4\n"
      "Ctrl-C ends it without a file.");
  command
      ->add_option(
          "MESH", options->mesh,
          "OBJ, PLY, OFF or STL file, or builtin:torusknot, builtin:sphere; or a scene, for "
          "all of its objects and its receiver")
      ->required();
  command->add_option("-o,--output", options->output, "Transfer to write (.prt)")->required();
  command
      ->add_option("--order", options->transfer.order,
                   "Bands of spherical harmonics, order² coefficients a vertex")
      ->check(CLI::Range(1, maximumTransferOrder))
      ->capture_default_str();
  CLI::Option* bounces = command
                             ->add_option("--bounces", options->transfer.bounces,
                                          "Reflections of the mesh onto itself, 0: shadows alone")
                             ->check(CLI::Range(0, maximumTransferBounces))
                             ->capture_default_str();
  CLI::Option* rays = command
                          ->add_option("--rays", options->transfer.raysPerVertex,
                                       "Rays from each vertex, for shadows and reflections")
                          ->check(CLI::Range(1, maximumTransferRays))
                          ->capture_default_str();
  command->add_flag("--unshadowed", options->unshadowed, "The cosine alone: no rays")
      ->excludes(bounces)
      ->excludes(rays);
  command->add_option("--albedo", options->albedo,
                      "Of the whole mesh: R,G,B, or one number for grey [0.5]");
  addSeedOption(*command, options->transfer.seed, "Seed of the rays' directions");
  addGeneralOptions(*command, options->general);
  command->callback([options, bounces] {
    options->bouncesGiven = bounces->count() > 0;
    prt(*options);
  });
}

}  // namespace haarlight
