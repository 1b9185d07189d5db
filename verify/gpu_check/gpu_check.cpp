/// haarlight-gpu-check: the checks of scripts/gpu-check that need the engines.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <new>
#include <span>

#include "base/error.h"
#include "base/file.h"
#include "verify/gpu_check/gpu_check_run.h"
#include "verify/report/host.h"

namespace haarlight::verify {

namespace {

constexpr const char* usage =
    "haarlight-gpu-check [-o FILE] [--small] [--step NAME RESULT DETAILS]...\n"
    "\n"
    "Compares every engine on every device with the scalar reference bit by bit, and measures\n"
    "frames per second and memory of the paper's frames.\n"
    "\n"
    "  -o FILE   Write a record (JSON)\n"
    "  --small   A few cases on CUDA GPUs only, nothing measured: for compute-sanitizer\n"
    "  --step NAME RESULT DETAILS\n"
    "            Note in the record that something passed, failed or did not run (\"not run\");\n"
    "            may be repeated\n"
    "\n"
    "Exit code 0: all agree; 1: a mismatch or a failure; 2: wrong usage.\n";

constexpr std::size_t smallCaseCount = 6;

struct Arguments {
  std::string output;
  std::vector<Step> steps;
  bool isSmall = false;
  bool wantsHelp = false;
};

void checkTarget(const std::string& file) {
  const std::filesystem::path target = file;
  const auto folder = target.has_parent_path() ? target.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw InputError("cannot write " + file + ": there is no folder " + folder.string());
}

Arguments parse(std::span<char*> words) {
  Arguments arguments;
  const auto take = [&](const std::string& option) -> std::string {
    if (words.empty()) throw InputError(option + " needs more words; see --help");
    const char* word = words.front();
    words = words.subspan(1);
    return word;
  };
  while (!words.empty()) {
    const std::string option = take("");
    if (option == "-o") {
      checkTarget(arguments.output = take(option));
    } else if (option == "--step") {
      const std::string name = take(option);
      const StepResult result = stepResult(take(option));
      arguments.steps.push_back({name, result, take(option)});
    } else if (option == "--small") {
      arguments.isSmall = true;
    } else if (option == "--help") {
      arguments.wantsHelp = true;
    } else {
      throw InputError("unknown option '" + option + "'; see --help");
    }
  }
  return arguments;
}

void requireCudaDevice() {
  std::string problem;
  for (const DeviceDescription& device : listDevices()) {
    if (device.engine != "cuda") continue;
    if (device.problem.empty()) return;
    problem = device.problem;
  }
  throw InputError(problem);
}

GpuCheckOptions optionsFor(const Arguments& arguments) {
  GpuCheckOptions options;
  options.run.progress = [shown = std::string()](const std::string& task, double) mutable {
    if (task != shown) std::fprintf(stderr, "haarlight: %s\n", task.c_str());
    shown = task;
  };
  if (arguments.isSmall) {
    requireCudaDevice();
    options.run.engines = {"cuda"};
    options.run.knownCases = false;
    options.run.randomCases = smallCaseCount;
    options.measures = false;
  } else {
    for (const int spheres : {paperSphereCounts.front(), paperSphereCounts.back()})
      options.run.cases.push_back(paperFrame(spheres));
  }
  return options;
}

int check(const Arguments& arguments) {
  const GpuCheckOptions options = optionsFor(arguments);
  const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  GpuCheckRecord record = checkGpus(options, table);
  record.report.program = "haarlight " HAARLIGHT_VERSION;
  record.report.host = hostDescription();
  record.report.date = utcNow();
  record.steps = arguments.steps;
  if (!arguments.output.empty()) writeFileAtomically(arguments.output, jsonRecord(record));
  std::fputs(textRecord(record).c_str(), stdout);
  if (!record.showsGpuRun()) std::fprintf(stderr, "haarlight: %s\n", noGpuNote);
  return record.passes() ? 0 : 1;
}

int runProgram(std::span<char*> words) {
  const Arguments arguments = parse(words);
  if (!arguments.wantsHelp) return check(arguments);
  std::fputs(usage, stdout);
  return 0;
}

int fail(int exitCode, const char* problem) {
  std::fprintf(stderr, "haarlight: error: %s\n", problem);
  return exitCode;
}

}  // namespace

}  // namespace haarlight::verify

int main(int argc, char** argv) {
  using namespace haarlight;
  try {
    const int status = verify::runProgram(std::span(argv, std::size_t(argc)).subspan(1));
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw InputError("cannot write to standard output");
    return status;
  } catch (const InputError& problem) {
    return verify::fail(2, problem.what());
  } catch (const std::bad_alloc&) {
    return verify::fail(1, "out of memory");
  } catch (const std::exception& problem) {
    return verify::fail(1, problem.what());
  }
}
