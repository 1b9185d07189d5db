#include <fmt/format.h>

#include "app/commands.h"
#include "app/options.h"
#include "base/file.h"
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

struct DevicesOptions {
  GeneralOptions general;
  bool budget = false;
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

void listAll(const DevicesOptions& options) {
  Console console(options.general.json, options.general.quiet);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::shared_ptr<const SphereTable> table;
  if (options.budget) table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  for (const DeviceDescription& device : listDevices()) {
    list.push_back(describe(device));
    if (options.budget && device.problem.empty() && device.engine != "reference")
      list.back()["budget"] = describeBudget(device, table);
  }
  console.results({{"device", list}});
  if (const std::string advice = openClAdvice(); !advice.empty()) console.warning(advice);
}

}  // namespace

void addDevicesCommand(CLI::App& app) {
  const auto options = std::make_shared<DevicesOptions>();
  CLI::App* command =
      app.add_subcommand("devices", "List the devices of all engines and what can run on them");
  command->footer("Example: haarlight devices --json");
  command->add_flag("--budget", options->budget,
                    "Also what the paper's frame takes of each device, against a GeForce 8800's "
                    "768 MB and 16 KiB");
  addGeneralOptions(*command, options->general);
  command->callback([options] { listAll(*options); });
}

}  // namespace haarlight
