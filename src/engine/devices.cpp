#include "engine/devices.h"

#include <algorithm>

#include "base/error.h"
#include "engine/opencl/opencl_engine.h"

namespace haarlight {

std::vector<DeviceDescription> listDevices() {
  DeviceDescription reference;
  reference.engine = "reference";
  reference.name = "scalar C++, one thread";
  reference.platform = "host";
  reference.computeUnits = 1;
  std::vector<DeviceDescription> list{reference};
  for (const DeviceDescription& device : listOpenClDevices()) list.push_back(device);
  return list;
}

std::unique_ptr<Engine> makeEngine(const EngineOptions& options,
                                   std::shared_ptr<const SphereTable> table) {
  if (options.engine == "reference") return makeReferenceEngine(std::move(table));
  if (options.engine == "opencl") return makeOpenClEngine(options, std::move(table));
  if (options.engine != "auto")
    throw InputError("unknown engine '" + options.engine + "': use auto, reference or opencl");
  const auto devices = listOpenClDevices();
  const bool usable = std::ranges::any_of(
      devices, [](const DeviceDescription& device) { return device.problem.empty(); });
  if (usable || !options.device.empty()) return makeOpenClEngine(options, std::move(table));
  return makeReferenceEngine(std::move(table));
}

}  // namespace haarlight
