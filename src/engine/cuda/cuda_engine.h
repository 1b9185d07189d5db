#pragma once

/// The kernels of cuda/ as devices: NVIDIA GPUs ("cuda"), and the host in their place
/// ("cuda-host"), which is there in every build.

#include "engine/devices.h"
#include "engine/kernel_device.h"

namespace haarlight {

/// NVIDIA GPUs; none without the driver or in a build without CUDA, see cudaAdvice().
std::vector<DeviceDescription> listCudaDevices();

/// The GPU that the options name. Throws InputError when there is none or it cannot be used.
std::unique_ptr<KernelDevice> openCudaDevice(const EngineOptions& options);

/// One emulated device (engine/cuda/host_emulation.h).
std::vector<DeviceDescription> listCudaHostDevices();

std::unique_ptr<KernelDevice> openCudaHostDevice(const EngineOptions& options);

}  // namespace haarlight
