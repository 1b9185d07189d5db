#include "engine/cuda/cuda_devices.h"

#include "base/error.h"
#include "engine/cuda/cuda_check.h"
#include "engine/cuda/cuda_engine.h"
#include "engine/cuda/cuda_kernels.h"
#include "engine/device_selection.h"

namespace haarlight {

namespace {

/// 13000 → "13.0".
std::string versionText(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

/// The CUDA version that the driver supports; 0 without a driver.
int driverVersion() {
  int version = 0;
  return cudaDriverGetVersion(&version) == cudaSuccess ? version : 0;
}

std::string reasonOf(cudaError_t status) {
  if (driverVersion() == 0) return "the NVIDIA driver is not installed";
  if (status == cudaErrorNoDevice) return "the NVIDIA driver finds no GPU";
  if (status == cudaErrorInsufficientDriver)
    return "the NVIDIA driver supports CUDA " + versionText(driverVersion()) +
           ", this build needs CUDA " + versionText(CUDART_VERSION);
  return cudaGetErrorString(status);
}

/// `why` is set when there is no device.
int deviceCount(std::string& why) {
  int count = 0;
  const cudaError_t status = cudaGetDeviceCount(&count);
  cudaGetLastError();  // no later call shall report it again
  if (status == cudaSuccess && count > 0) return count;
  why = "no CUDA device: " + reasonOf(status == cudaSuccess ? cudaErrorNoDevice : status);
  return 0;
}

/// Whether the GPU takes the kernels: they are compiled for the architectures that the toolkit of
/// the build knew.
std::string problemOf(int index) {
  cudaFuncAttributes attributes;
  cudaError_t status = cudaSetDevice(index);
  if (status == cudaSuccess)
    status = cudaFuncGetAttributes(&attributes, cudaKernels().front().function);
  cudaGetLastError();
  if (status == cudaSuccess) return {};
  return std::string("its kernels do not load: ") + cudaGetErrorString(status);
}

DeviceDescription describe(int index) {
  cudaDeviceProp properties;
  HAARLIGHT_CUDA_CALL(cudaGetDeviceProperties, &properties, index);
  DeviceDescription device;
  device.engine = "cuda";
  device.index = index;
  device.name = properties.name;
  device.platform = "CUDA";
  device.version = "compute capability " + std::to_string(properties.major) + "." +
                   std::to_string(properties.minor);
  device.driver = "CUDA " + versionText(driverVersion());
  device.computeUnits = properties.multiProcessorCount;
  device.globalMemory = properties.totalGlobalMem;
  device.localMemory = properties.sharedMemPerBlock;
  device.problem = problemOf(index);
  return device;
}

}  // namespace

std::vector<DeviceDescription> listCudaDevices() {
  std::vector<DeviceDescription> devices;
  std::string ignored;
  const int count = deviceCount(ignored);
  for (int index = 0; index < count; ++index) devices.push_back(describe(index));
  return devices;
}

std::string cudaAdvice() {
  std::string why;
  deviceCount(why);
  return why;
}

DeviceDescription chooseCudaDevice(const std::string& selector) {
  const auto devices = listCudaDevices();
  if (devices.empty()) throw InputError(cudaAdvice());
  std::vector<DeviceChoice> choices;
  for (const DeviceDescription& device : devices)
    choices.push_back({device.name, false, device.problem});
  return devices[chooseDevice("CUDA", choices, selector)];
}

}  // namespace haarlight
