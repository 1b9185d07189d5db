#pragma once

#include "engine/devices.h"
#include "engine/kernel_device.h"

namespace haarlight {

std::vector<DeviceDescription> listOpenClDevices();

/// Builds the kernels for the device that the options name. Throws InputError for an unknown
/// device.
std::unique_ptr<KernelDevice> openOpenClDevice(const EngineOptions& options);

}  // namespace haarlight
