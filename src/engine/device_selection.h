#pragma once

#include <string>
#include <vector>

namespace haarlight {

/// What choosing a device depends on.
struct DeviceChoice {
  std::string name;
  bool isCpu = false;
  /// Why it cannot be used; empty when it can.
  std::string problem;
};

/// Index of the device that `selector` names: an index, a part of a device's name (case does not
/// matter), or empty for the first usable one, GPUs first. `api` names the kind of device in
/// messages ("OpenCL"). Throws InputError in words when there is none or it cannot be used.
std::size_t chooseDevice(const std::string& api, const std::vector<DeviceChoice>& devices,
                         const std::string& selector);

}  // namespace haarlight
