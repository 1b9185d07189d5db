#include <fmt/format.h>

#include "app/commands.h"
#include "app/options.h"

namespace haarlight {

namespace {

nlohmann::ordered_json describe(const DeviceDescription& device) {
  nlohmann::ordered_json entry{{"engine", device.engine},
                               {"index", device.index},
                               {"name", device.name},
                               {"platform", device.platform},
                               {"usable", device.problem.empty()}};
  if (!device.problem.empty()) entry["problem"] = device.problem;
  if (!device.version.empty()) entry["version"] = device.version;
  if (!device.driver.empty()) entry["driver"] = device.driver;
  entry["compute_units"] = device.computeUnits;
  if (device.globalMemory) {
    entry["global_memory_bytes"] = device.globalMemory;
    entry["local_memory_bytes"] = device.localMemory;
  }
  return entry;
}

void listAll(const GeneralOptions& options) {
  Console console(options.json, options.quiet);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DeviceDescription& device : listDevices()) list.push_back(describe(device));
  console.results({{"device", list}});
  if (const std::string advice = openClAdvice(); !advice.empty()) console.warning(advice);
}

}  // namespace

void addDevicesCommand(CLI::App& app) {
  const auto options = std::make_shared<GeneralOptions>();
  CLI::App* command =
      app.add_subcommand("devices", "List the devices of all engines and what can run on them");
  command->footer("Example: haarlight devices --json");
  addGeneralOptions(*command, *options);
  command->callback([options] { listAll(*options); });
}

}  // namespace haarlight
