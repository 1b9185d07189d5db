#include <fmt/format.h>

#include <cstdio>

#include "app/bench_run.h"
#include "app/commands.h"
#include "base/file.h"
#include "base/parallel.h"
#include "benchmark/reports.h"
#include "scene/names.h"

namespace haarlight {

namespace {

using namespace benchmark;

void checkTargets(const BenchOptions& options) {
  if (!options.output.empty()) checkTarget(options.output, {".json"});
  if (!options.csv.empty()) checkTarget(options.csv, {".csv"});
  if (!options.svg.empty()) checkTarget(options.svg, {".svg"});
}

void writeReports(const BenchOptions& options, const Record& record, const Comparison* comparison,
                  Console& console) {
  const nlohmann::ordered_json json = jsonReport(record, comparison);
  if (!options.output.empty()) writeFileAtomically(options.output, json.dump(2) + "\n");
  if (!options.csv.empty()) writeFileAtomically(options.csv, csvReport(record));
  if (!options.svg.empty()) writeFileAtomically(options.svg, svgReport(record));
  if (record.interrupted) console.warning("interrupted; these are the figures so far");
  if (options.general.json) return console.results(json);
  const std::string text = textReport(record, comparison);
  console.message("");
  std::fwrite(text.data(), 1, text.size(), stdout);  // main looks for errors on the stream
}

void bench(const BenchOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  checkTargets(options);
  std::optional<EarlierRecord> earlier;
  if (!options.compare.empty()) earlier = readRecord(options.compare);
  const Record record = runBench(options, console);
  std::optional<Comparison> comparison;
  if (earlier) {
    comparison = compareRows(namedTimes(record), *earlier);
    if (earlier->host != record.host)
      console.warning(earlier->file + " was measured on another machine: " + earlier->host);
  }
  writeReports(options, record, comparison ? &*comparison : nullptr, console);
}

void addTableOptions(CLI::App& command, BenchOptions& options) {
  const auto list = [&](const char* name, std::vector<int>& values, const char* help, int most) {
    command.add_option(name, values, help)
        ->group("Table")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::Range(name == std::string("--terms") ? 0 : 1, most))
        ->capture_default_str();
  };
  list("--spheres", options.spheres, "Numbers of spheres to fit to each object", 4096);
  list("--terms", options.terms, "Numbers of light wavelets", maximumTerms);
  list("--levels", options.levels, "Levels of visibility", 2);
  command.add_option("--size", options.size, "Columns x rows of the plane's samples [128x128]")
      ->group("Table");
  command.add_option("--frames", options.frames, "Frames of each row")
      ->group("Table")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
}

void addSubjectOptions(CLI::App& command, BenchOptions& options) {
  command
      .add_option("--engine", options.subjects.engines,
                  "Only this engine: opencl, cuda, reference or cuda-host; may be repeated [opencl "
                  "and cuda; the others are slow]")
      ->allow_extra_args(false)
      ->group("Computation");
  command
      .add_option("--device", options.subjects.device,
                  "Only devices of this index, or with this in their names")
      ->group("Computation");
  const auto choice = [&](const char* name, std::string& value, const std::string& help,
                          std::vector<std::string> choices) {
    choices.push_back("both");
    command.add_option(name, value, help)
        ->group("Computation")
        ->check(CLI::IsMember(choices))
        ->capture_default_str();
  };
  choice("--visibility", options.visibility, "exact, table or both", namesOf(visibilityKindNames));
  choice("--path", options.path, "fused (one kernel), staged (three) or both",
         namesOf(framePathNames));
}

void addModeOptions(CLI::App& command, BenchOptions& options) {
  CLI::Option* peers = command.add_flag("--peers", options.peers,
                                        "Also other ways to the same picture: time and error");
  CLI::Option* compare =
      command
          .add_option("--compare", options.compare,
                      "Record of an earlier run (.json): ratios of times, row by row")
          ->group("Table");
  CLI::Option* ceilings =
      command
          .add_flag("--ceilings", options.ceilings,
                    "Also the processor's measured bandwidths and rates, and how near to them "
                    "stages come")
          ->group("Table");
  CLI::Option* csv =
      command.add_option("--csv", options.csv, "Table to write (.csv)")->group("Output");
  command
      .add_flag(
          "--scale", options.scale,
          "Instead of the table: how time grows with samples, spheres and terms, on the first "
          "engine")
      ->group("Scale")
      ->excludes(peers)
      ->excludes(compare)
      ->excludes(csv)
      ->excludes(ceilings);
  command.add_option("--scale-samples", options.scaleSamples, "Most samples of --scale")
      ->group("Scale")
      ->check(CLI::Range(std::size_t(1) << 10, std::size_t(1) << 24))
      ->capture_default_str();
  peers->group("Table");
}

}  // namespace

void addBenchCommand(CLI::App& app) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand(
      "bench", "Measure frames per second as the paper's Table 2 does, on every engine and device");
  command->footer(
      "Examples:\n"
      "  haarlight bench --svg bench.svg -o bench.json\n"
      "  haarlight bench --compare bench.json\n"
      "  haarlight bench --mesh bunny.obj --light grace.hdr --visibility exact --peers\n"
      "  haarlight bench --ceilings --spheres 64 --terms 200 --levels 2\n"
      "  haarlight bench --scale --visibility exact\n"
      "What is timed is said in the results and in docs/benchmark.md.");
  addSceneContentOptions(*command, options->scene);
  addTableOptions(*command, *options);
  addSubjectOptions(*command, *options);
  addModeOptions(*command, *options);
  command->add_option("-o,--output", options->output, "Record to write (.json), for --compare")
      ->group("Output");
  command->add_option("--svg", options->svg, "Plots to write (.svg)")->group("Output");
  addGeneralOptions(*command, options->general);
  command->callback([options] { bench(*options); });
}

}  // namespace haarlight
