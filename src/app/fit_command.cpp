#include <filesystem>

#include "app/commands.h"
#include "app/options.h"
#include "base/parallel.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "spheres/fit_spheres.h"

namespace haarlight {

namespace {

struct FitOptions {
  GeneralOptions general;
  std::string mesh;
  std::string output;
  int spheres = 64;
  std::uint64_t seed = 0;
};

void fit(const FitOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  checkTarget(options.output, {".json"});
  const LoadedMesh loaded = loadMeshOrBuiltin(options.mesh);
  for (const std::string& warning : loaded.warnings) console.warning(options.mesh + ": " + warning);
  SphereFitOptions fitOptions;
  fitOptions.seed = options.seed;
  if (const Progress progress = console.progress())
    fitOptions.progress = [progress](double finished) { progress("fitting", finished); };
  SphereSet set = fitSpheres(loaded.mesh, std::size_t(options.spheres), fitOptions);
  set.meshName = std::filesystem::path(options.mesh).filename().string();
  writeSphereSet(options.output, set);
  nlohmann::ordered_json results{{"set", options.output},
                                 {"spheres", set.spheres.size()},
                                 {"triangles", loaded.mesh.triangles.size()},
                                 {"covered_surface", set.measures.coveredFraction}};
  if (set.measures.outsideVolumeRatio)
    results["outside_volume_ratio"] = *set.measures.outsideVolumeRatio;
  console.results(results);
}

}  // namespace

void addFitCommand(CLI::App& app) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Fit spheres to a mesh");
  command->footer("Example: haarlight fit bunny.obj --spheres 64 -o bunny.json");
  command
      ->add_option("MESH", options->mesh,
                   "OBJ, PLY, OFF or STL file, or builtin:torusknot, "
                   "builtin:sphere")
      ->required();
  command->add_option("-o,--output", options->output, "Sphere set to write (.json)")->required();
  command->add_option("--spheres", options->spheres, "How many spheres")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  addSeedOption(*command, options->seed, "Seed of the random numbers");
  addGeneralOptions(*command, options->general);
  command->callback([options] { fit(*options); });
}

}  // namespace haarlight
