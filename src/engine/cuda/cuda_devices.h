#pragma once

#include <string>

#include "engine/devices.h"

namespace haarlight {

/// The GPU to run on (engine/device_selection.h). Throws InputError in words when there is none.
DeviceDescription chooseCudaDevice(const std::string& selector);

}  // namespace haarlight
