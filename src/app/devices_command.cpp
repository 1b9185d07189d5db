#include <fmt/format.h>

#include <cstdlib>

#include "app/commands.h"
#include "app/device_tuning.h"
#include "app/options.h"
#include "base/file.h"
#include "base/parallel.h"
#include "engine/shape_choice.h"
#include "verify/cases/paper_frame.h"

namespace haarlight {

namespace {

nlohmann::ordered_json describe(const DeviceDescription& device) {
  nlohmann::ordered_json entry{{"engine", device.engine},
                               {"index", device.index},
                               {"name", device.name},
                               {"platform", device.platform},
                               {"usable", device.problem.empty()}};
  if (!device.problem.empty()) entry["problem"] = device.problem;
  if (device.emulation) entry["emulation"] = true;
  if (!device.numericLimitation.empty()) entry["numeric_limitation"] = device.numericLimitation;
  if (!device.version.empty()) entry["version"] = device.version;
  if (!device.driver.empty()) entry["driver"] = device.driver;
  entry["compute_units"] = device.computeUnits;
  if (device.globalMemory) {
    entry["global_memory_bytes"] = device.globalMemory;
    entry["local_memory_bytes"] = device.localMemory;
  }
  return entry;
}

/// The shape that engines open a device in, and who says so.
nlohmann::ordered_json describeChoice(const ShapeChoice& choice) {
  nlohmann::ordered_json entry = describeShape(choice.shape);
  entry["from"] = choice.source == ShapeSource::tuned         ? "tuning"
                  : choice.source == ShapeSource::environment ? shapeVariable
                                                              : "default";
  return entry;
}

struct DevicesOptions {
  GeneralOptions general;
  bool budget = false;
  bool tune = false;
  TuneOptions tuning;
};

/// What the paper's frame takes of a device, in the shape for GPUs, beside what a GeForce 8800 has.
nlohmann::ordered_json describeBudget(const DeviceDescription& device,
                                      const std::shared_ptr<const SphereTable>& table) {
  EngineOptions options = optionsFor(device);
  options.lanesPerItem = 1;
  const auto engine = makeEngine(options, table);
  const verify::Budget budget = verify::budgetOf(*engine);
  nlohmann::ordered_json entry{{"device_memory_bytes", budget.memoryBytes},
                               {"device_memory_limit_bytes", verify::Budget::memoryLimit},
                               {"work_items_per_group", budget.itemsPerGroup},
                               {"work_items_limit", verify::Budget::itemsLimit},
                               {"local_memory_limit_bytes", verify::Budget::localLimit}};
  for (const DeviceUse::Kernel& kernel : engine->deviceUse().kernels)
    entry["local_memory_bytes"][kernel.name] = kernel.localBytes;
  entry["kept"] = budget.isKept();
  return entry;
}

void listAll(const DevicesOptions& options, Console& console) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::shared_ptr<const SphereTable> table;
  if (options.budget) table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  const TunedShapes tuned = TunedShapes::read(
      cacheFolder(), [&](const std::string& warning) { console.warning(warning); });
  for (const DeviceDescription& device : listDevices()) {
    list.push_back(describe(device));
    if (!device.problem.empty() || device.engine == "reference") continue;
    list.back()["shape"] =
        describeChoice(chooseShape({}, device, std::getenv(shapeVariable), tuned));
    if (options.budget) list.back()["budget"] = describeBudget(device, table);
  }
  console.results({{"device", list}});
  if (const std::string advice = openClAdvice(); !advice.empty()) console.warning(advice);
}

void run(const DevicesOptions& options) {
  Console console(options.general.json, options.general.quiet);
  setThreadCount(options.general.threads);
  if (options.tune)
    tuneDevices(options.tuning, options.general.json, console);
  else
    listAll(options, console);
}

void addTuneOptions(CLI::App& command, DevicesOptions& options) {
  const std::string group = "Tuning";
  CLI::Option* tune =
      command
          .add_flag("--tune", options.tune,
                    "Measure every work size on the devices and keep the best of each")
          ->group(group)
          ->excludes("--budget");
  command
      .add_option("--engine", options.tuning.engine,
                  "Only this engine: opencl, cuda or cuda-host [opencl and cuda]")
      ->group(group)
      ->needs(tune)
      ->check(CLI::IsMember({"opencl", "cuda", "cuda-host"}));
  command
      .add_option("--device", options.tuning.device,
                  "Only devices of this index, or with this in their names")
      ->group(group)
      ->needs(tune);
  command.add_option("--frames", options.tuning.frames, "Frames of each size")
      ->group(group)
      ->needs(tune)
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--samples", options.tuning.samples, "Samples of a frame")
      ->group(group)
      ->needs(tune)
      ->check(CLI::Range(std::size_t(1), benchmark::paperSamples))
      ->capture_default_str();
}

}  // namespace

void addDevicesCommand(CLI::App& app) {
  const auto options = std::make_shared<DevicesOptions>();
  CLI::App* command =
      app.add_subcommand("devices", "List the devices of all engines and what can run on them");
  command->footer(
      "Examples:\n"
      "  haarlight devices --json\n"
      "  haarlight devices --tune --engine opencl");
  command->add_flag("--budget", options->budget,
                    "Also what the paper's frame takes of each device, against a GeForce 8800's "
                    "768 MB and 16 KiB");
  addTuneOptions(*command, *options);
  addGeneralOptions(*command, options->general);
  command->callback([options] { run(*options); });
}

}  // namespace haarlight
