#pragma once

#include "engine/engine.h"
#include "engine/kernel_device.h"

namespace haarlight {

/// The engine that runs a frame's steps as kernels of a device, whichever its API is. Without a
/// table its visibility is exact. Uploads the tables and runs every kernel once.
std::unique_ptr<Engine> makeKernelEngine(std::unique_ptr<KernelDevice> device,
                                         std::shared_ptr<const SphereTable> table, FramePath path);

}  // namespace haarlight
