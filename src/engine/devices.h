#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/engine.h"

namespace haarlight {

/// A device that an engine can or cannot run on, as `haarlight devices` lists it.
struct DeviceDescription {
  std::string engine;
  /// Number to choose it by within its engine.
  int index = 0;
  std::string name;
  std::string platform;
  std::string version;
  std::string driver;
  int computeUnits = 0;
  /// Bytes; 0 when unknown.
  std::uint64_t globalMemory = 0;
  std::uint64_t localMemory = 0;
  /// Why it cannot be used; empty when it can.
  std::string problem;
};

/// Every device of every engine of this build.
std::vector<DeviceDescription> listDevices();

/// What to tell someone whose machine has no OpenCL device, or empty when it has one.
std::string openClAdvice();

struct EngineOptions {
  /// "auto" (OpenCL when a device is there, else reference), "reference" or "opencl".
  std::string engine = "auto";
  /// OpenCL device by index or by a part of its name; empty: the first usable one, GPUs first.
  std::string device;
  /// Lanes a work-item carries, 1 or 32 (opencl/lanes.cl); 0: what suits the device.
  int lanesPerItem = 0;
};

/// An engine that looks visibility up in `table`, or with none finds it exactly
/// (visibility/visibility_kind.h). Throws InputError for an unknown engine or device.
std::unique_ptr<Engine> makeEngine(const EngineOptions& options,
                                   std::shared_ptr<const SphereTable> table);

}  // namespace haarlight
