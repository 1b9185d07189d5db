#pragma once

#include "engine/devices.h"

namespace haarlight {

std::vector<DeviceDescription> listOpenClDevices();

/// Builds the kernels and uploads the tables. Throws InputError for an unknown device.
std::unique_ptr<Engine> makeOpenClEngine(const EngineOptions& options,
                                         std::shared_ptr<const SphereTable> table);

}  // namespace haarlight
