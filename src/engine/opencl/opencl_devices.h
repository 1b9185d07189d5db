#pragma once

#include <string>
#include <vector>

#include "engine/devices.h"
#include "engine/opencl/opencl_api.h"

namespace haarlight {

/// An OpenCL device as found, with the platform it belongs to.
struct OpenClDevice {
  cl::Device device;
  /// Place in findOpenClDevices().
  int index = 0;
  std::string name;
  std::string platform;
  bool isCpu = false;
  /// Engine::numericLimitation.
  std::string numericLimitation;
  /// Why the engine cannot run on it; empty when it can.
  std::string problem;
};

/// All devices of all platforms, in the loader's order. No platform (the loader's error −1001) is
/// an empty list.
std::vector<OpenClDevice> findOpenClDevices();

/// The device to run on: `selector` is an index into findOpenClDevices(), a part of a device's name
/// (case does not matter), or empty for the first usable one, GPUs first. Throws InputError in
/// words when there is none.
OpenClDevice chooseOpenClDevice(const std::string& selector);

/// The same in the words of all engines.
DeviceDescription describe(const OpenClDevice& device);

}  // namespace haarlight
