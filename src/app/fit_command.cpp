#include <fmt/format.h>

#include <filesystem>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/version.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/text_format.h"
#include "mesh/mesh_file.h"
#include "mesh/text_lines.h"
#include "report/fit_report.h"
#include "report/measures_json.h"
#include "scene/names.h"
#include "spheres/fit_spheres.h"
#include "verify/report/host.h"

namespace haarlight {

namespace {

struct FitOptions {
  GeneralOptions general;
  std::string mesh;
  std::string output;
  std::string report;
  std::optional<std::size_t> spheres;
  std::string objective = std::string(nameOf(FitObjective::shadow));
  SphereFitOptions fit;
};

constexpr std::size_t defaultSpheres = 64;

/// The most spheres to use: as asked, or as many as --max-error needs.
std::size_t mostSpheres(const FitOptions& options) {
  if (options.spheres) return *options.spheres;
  return options.fit.maximumError ? maximumFittedSpheres : defaultSpheres;
}

/// CLI11's own check says the largest double in full.
std::string greaterThanZero(const std::string& text) {
  double value = 0;
  const bool good = parseNumber(text, value) && value > 0;
  return good ? "" : "must be a number greater than zero, not " + text;
}

SphereFit runFit(const FitOptions& options, const LoadedMesh& loaded, Console& console) {
  const InterruptWatch watch;
  SphereFitOptions fitOptions = options.fit;
  fitOptions.objective = choiceOf(fitObjectiveNames, options.objective);
  fitOptions.cancelled = [&] { return watch.interrupted(); };
  if (const Progress progress = console.progress())
    fitOptions.progress = [progress, &console](const FitProgress& fit) {
      progress("fitting", fit.finished);
      console.progressDetail(fmt::format("error {:.4f}", fit.error));
    };
  try {
    SphereFit result = fitSpheres(loaded.mesh, mostSpheres(options), fitOptions);
    result.set.meshName = std::filesystem::path(options.mesh).filename().string();
    return result;
  } catch (const InputError& error) {
    throw InputError(options.mesh + ": " + error.what());
  }
}

void writeReport(const FitOptions& options, const LoadedMesh& loaded, const SphereFit& fit) {
  writeFitReport(options.report, {.program = "haarlight " HAARLIGHT_VERSION,
                                  .host = verify::hostDescription(),
                                  .date = verify::utcNow(),
                                  .requestedSpheres = mostSpheres(options),
                                  .maximumError = options.fit.maximumError,
                                  .timeLimit = options.fit.timeLimit,
                                  .mesh = loaded,
                                  .fit = fit});
}

/// What a user should know about how the fit ended.
void explainEnd(const FitOptions& options, const SphereFit& fit, Console& console) {
  const std::size_t count = fit.set.spheres.size();
  if (fit.stop == FitStop::cancelled || fit.stop == FitStop::timeLimit)
    console.warning(fmt::format("{} after {:.1f} s; this is the best set so far",
                                stopText(fit.stop), fit.seconds));
  else if (options.fit.maximumError && fit.stop != FitStop::errorReached)
    console.warning(fmt::format("{} spheres reach no smaller error than {:.4g}", count,
                                fit.history.back().error));
  else if (!options.fit.maximumError && count < mostSpheres(options))
    console.message(fmt::format("{} spheres are enough: another would not lower the error", count));
}

void fit(const FitOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  checkTarget(options.output, {".json"});
  if (!options.report.empty()) checkTarget(options.report, {".html", ".json"});
  const LoadedMesh loaded = loadMeshOrBuiltin(options.mesh);
  for (const std::string& warning : loaded.warnings) console.warning(options.mesh + ": " + warning);
  const SphereFit fit = runFit(options, loaded, console);
  for (const std::string& warning : fit.warnings) console.warning(options.mesh + ": " + warning);
  explainEnd(options, fit, console);
  writeSphereSet(options.output, fit.set);
  if (!options.report.empty()) writeReport(options, loaded, fit);
  nlohmann::ordered_json results{{"set", options.output},
                                 {"spheres", fit.set.spheres.size()},
                                 {"triangles", loaded.mesh.triangles.size()},
                                 {"objective", options.objective},
                                 {"stopped", stopName(fit.stop)},
                                 {"seconds", fit.seconds}};
  results.update(measuresJson(fit.set.measures));
  if (!options.report.empty()) results["report"] = options.report;
  console.results(results);
}

}  // namespace

void addFitCommand(CLI::App& app) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Fit spheres to a mesh");
  command->footer(
      "Examples:\n"
      "  haarlight fit bunny.obj --spheres 64 -o bunny.json --report bunny.html\n"
      "  haarlight fit bunny.obj --max-error 0.05 -o bunny.json\n"
      "Ctrl-C ends a fit with the best set so far.");
  command
      ->add_option("MESH", options->mesh,
                   "OBJ, PLY, OFF or STL file, or builtin:torusknot, "
                   "builtin:sphere")
      ->required();
  command->add_option("-o,--output", options->output, "Sphere set to write (.json)")->required();
  command
      ->add_option("--spheres", options->spheres,
                   fmt::format("How many spheres [{}]; with --max-error the most", defaultSpheres))
      ->check(CLI::Range(std::size_t(1), maximumFittedSpheres));
  command
      ->add_option("--objective", options->objective,
                   "shadow: least silhouette error, over- and under-blocking alike; cover: every "
                   "point of the mesh in a sphere, least volume outside")
      ->check(CLI::IsMember(namesOf(fitObjectiveNames)))
      ->capture_default_str();
  command
      ->add_option("--max-error", options->fit.maximumError,
                   "As many spheres as this error takes: the mean silhouette error for shadow, the "
                   "summed outside volume by the mesh's for cover")
      ->check(greaterThanZero);
  command
      ->add_option("--time-limit", options->fit.timeLimit,
                   "Seconds after which the best set so far is taken")
      ->check(greaterThanZero);
  command->add_option("--report", options->report,
                      "Report to write: .html with plot and pictures, or .json");
  addSeedOption(*command, options->fit.seed, "Seed of the random numbers");
  addGeneralOptions(*command, options->general);
  command->callback([options] { fit(*options); });
}

}  // namespace haarlight
