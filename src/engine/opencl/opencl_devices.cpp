#include "engine/opencl/opencl_devices.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "engine/device_selection.h"

namespace haarlight {

namespace {

/// The groups of the sphere table (40 MiB), and some room.
constexpr std::uint64_t bufferBytesNeeded = 48 << 20;
constexpr std::uint64_t localBytesNeeded = 16 << 10;

/// The bindings leave a terminating zero or blanks in some drivers' strings.
std::string trimmed(std::string text) {
  const auto isBlank = [](unsigned char c) { return c == 0 || std::isspace(c); };
  while (!text.empty() && isBlank(text.back())) text.pop_back();
  text.erase(text.begin(), std::ranges::find_if_not(text, isBlank));
  return text;
}

std::string problemOf(const cl::Device& device) {
  if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "the driver says it is not available";
  if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "it has no kernel compiler";
  if (device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>() < bufferBytesNeeded)
    return "it cannot hold the sphere table in one buffer of 48 MiB";
  if (device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>() < localBytesNeeded)
    return "it has less than 16 KiB of local memory";
  if (device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>() < 32) return "its work-groups are too small";
  return {};
}

/// Additions, multiplications and fma are correctly rounded on every device of the full profile;
/// denormal numbers are optional.
std::string numericLimitationOf(const cl::Device& device) {
  const auto config = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
  if (!(config & CL_FP_ROUND_TO_NEAREST)) return "it does not round to nearest";
  if (!(config & CL_FP_DENORM)) return "it flushes denormal numbers to zero";
  return {};
}

OpenClDevice foundDevice(const cl::Platform& platform, const cl::Device& device, int index) {
  OpenClDevice found;
  found.device = device;
  found.index = index;
  found.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
  found.platform = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
  found.isCpu = device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU;
  found.numericLimitation = numericLimitationOf(device);
  found.problem = problemOf(device);
  return found;
}

}  // namespace

std::vector<OpenClDevice> findOpenClDevices() {
  std::vector<OpenClDevice> found;
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {  // -1001: no platform installed
    return found;
  }
  for (const cl::Platform& platform : platforms) {
    std::vector<cl::Device> devices;
    try {
      platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error&) {  // a platform without devices
      continue;
    }
    for (const cl::Device& device : devices)
      found.push_back(foundDevice(platform, device, int(found.size())));
  }
  return found;
}

OpenClDevice chooseOpenClDevice(const std::string& selector) {
  const auto devices = findOpenClDevices();
  if (devices.empty()) throw InputError(openClAdvice());
  std::vector<DeviceChoice> choices;
  for (const OpenClDevice& d : devices) choices.push_back({d.name, d.isCpu, d.problem});
  return devices[chooseDevice("OpenCL", choices, selector)];
}

std::string openClAdvice() {
  if (!findOpenClDevices().empty()) return {};
  return "no OpenCL device was found: install the driver of your GPU, or `apt install "
         "pocl-opencl-icd` to run on the CPU";
}

DeviceDescription describe(const OpenClDevice& found) {
  DeviceDescription description;
  description.engine = "opencl";
  description.index = found.index;
  description.name = found.name;
  description.platform = found.platform;
  description.version = trimmed(found.device.getInfo<CL_DEVICE_VERSION>());
  description.driver = trimmed(found.device.getInfo<CL_DRIVER_VERSION>());
  description.computeUnits = int(found.device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>());
  description.globalMemory = found.device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  description.localMemory = found.device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
  description.isCpu = found.isCpu;
  description.numericLimitation = found.numericLimitation;
  description.problem = found.problem;
  return description;
}

std::vector<DeviceDescription> listOpenClDevices() {
  std::vector<DeviceDescription> list;
  for (const OpenClDevice& found : findOpenClDevices()) list.push_back(describe(found));
  return list;
}

}  // namespace haarlight
