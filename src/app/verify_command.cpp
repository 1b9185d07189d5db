#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "app/commands.h"
#include "app/options.h"
#include "app/scene_case.h"
#include "app/version.h"
#include "base/error.h"
#include "base/file.h"
#include "base/parallel.h"
#include "scene/names.h"
#include "verify/cases/case_file.h"
#include "verify/report/host.h"
#include "verify/report/report_writers.h"
#include "verify/run.h"

namespace haarlight {

namespace {

/// Pictures of scenes are this many pixels wide.
constexpr int frameWidth = 96;

struct VerifyOptions {
  GeneralOptions general;
  std::vector<std::string> engines;
  std::size_t cases = 500;
  std::uint64_t seed = 1;
  bool withoutScenes = false;
  std::string junit, html;
  std::string saveCase, replay;
  std::vector<std::string> inject;
};

void checkTargets(const VerifyOptions& options) {
  if (!options.junit.empty()) checkTarget(options.junit, {".xml"});
  if (!options.html.empty()) checkTarget(options.html, {".html"});
  if (!options.saveCase.empty()) checkTarget(options.saveCase, {".case"});
}

std::optional<verify::Injection> injectionOf(const VerifyOptions& options) {
  if (options.inject.empty()) return std::nullopt;
  return verify::Injection{verify::injectionKind(options.inject[0]), options.inject[1]};
}

verify::RunOptions runOptions(const VerifyOptions& options, const Progress& progress) {
  verify::RunOptions run;
  run.engines = options.engines;
  run.seed = options.seed;
  run.injection = injectionOf(options);
  run.shrinkFailure = !options.saveCase.empty();
  run.progress = progress;
  if (!options.replay.empty()) {
    run.knownCases = false;
    run.randomCases = 0;
    run.cases.push_back(verify::readCaseFile(options.replay));
    return run;
  }
  run.randomCases = options.cases;
  if (!options.withoutScenes)
    for (const std::string_view scene : builtinScenes)
      run.cases.push_back(sceneCase(std::string(scene), frameWidth, progress));
  return run;
}

void writeReports(const VerifyOptions& options, const verify::Report& report) {
  if (!options.junit.empty()) writeFileAtomically(options.junit, verify::junitReport(report));
  if (!options.html.empty()) writeFileAtomically(options.html, verify::htmlReport(report));
  const std::string text = options.general.json
                               ? verify::jsonReport(report)
                               : verify::textReport(report, colorsWanted(STDOUT_FILENO));
  std::fwrite(text.data(), 1, text.size(), stdout);  // main looks for errors on the stream
}

void verifyEngines(const VerifyOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  checkTargets(options);
  const Progress progress = console.progress();
  const auto run = runOptions(options, progress);
  const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  verify::RunResult result = verify::run(run, table);
  result.report.program = "haarlight " HAARLIGHT_VERSION;
  result.report.host = verify::hostDescription();
  result.report.date = verify::utcNow();
  writeReports(options, result.report);
  if (result.failingCase && !options.saveCase.empty()) {
    verify::writeCaseFile(options.saveCase, *result.failingCase);
    console.message("smallest failing case: " + options.saveCase);
  }
  if (!result.report.agrees()) throw std::runtime_error("the engines do not agree; see above");
}

void addCaseOptions(CLI::App& command, VerifyOptions& options) {
  CLI::Option* cases = command.add_option("--cases", options.cases, "Random cases")
                           ->group("Cases")
                           ->check(CLI::Range(0, 1000000))
                           ->capture_default_str();
  CLI::Option* seed =
      addSeedOption(command, options.seed, "Seed of the random cases")->group("Cases");
  CLI::Option* withoutScenes =
      command
          .add_flag("--without-scenes", options.withoutScenes, "No frames of the built-in scenes")
          ->group("Cases");
  command.add_option("--replay", options.replay, "Only the case in this file")
      ->group("Cases")
      ->check(CLI::ExistingFile)
      ->excludes(cases)
      ->excludes(seed)
      ->excludes(withoutScenes);
  command
      .add_option("--save-case", options.saveCase,
                  "Where to write the smallest failing case (.case)")
      ->group("Cases");
}

}  // namespace

void addVerifyCommand(CLI::App& app) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand(
      "verify", "Compare every engine on every device with the scalar reference, bit by bit");
  command->footer(
      "Exit code 0: all agree; 1: a mismatch.\n"
      "Example: haarlight verify --html report.html");
  addCaseOptions(*command, *options);
  command
      ->add_option("--engine", options->engines,
                   "Only this engine: opencl, cuda or cuda-host; may be repeated")
      ->allow_extra_args(false)
      ->group("Computation");
  command
      ->add_option(
          "--inject", options->inject,
          "Put faults into an engine's results, to see them found: sphere, bit, coefficient, ulp, "
          "exponentiation or transfer, and the engine")
      ->expected(2)
      ->type_name("FAULT ENGINE")
      ->group("Computation");
  command->add_option("--junit", options->junit, "Write a JUnit report (.xml)")->group("Output");
  command->add_option("--html", options->html, "Write a page with pictures (.html)")
      ->group("Output");
  addGeneralOptions(*command, options->general);
  command->callback([options] { verifyEngines(*options); });
}

}  // namespace haarlight
