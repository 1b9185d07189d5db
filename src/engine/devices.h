#pragma once

#include <functional>
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
  bool isCpu = false;
  /// Whether the device only imitates another one; `auto` never chooses it.
  bool emulation = false;
  /// Why results may differ in the last bits (Engine::numericLimitation); empty: they do not.
  std::string numericLimitation;
  /// Why it cannot be used; empty when it can.
  std::string problem;
};

/// Every device of every engine; CUDA without one is an entry with that problem.
std::vector<DeviceDescription> listDevices();

/// What to tell someone whose machine has no OpenCL device, or empty when it has one.
std::string openClAdvice();

/// The same about CUDA devices.
std::string cudaAdvice();

struct EngineOptions {
  /// "auto" (CUDA, then OpenCL GPUs, then OpenCL CPUs, else reference), "reference", "opencl",
  /// "cuda" or "cuda-host".
  std::string engine = "auto";
  /// Device by index or by a part of its name; empty: the first usable one, GPUs first.
  std::string device = {};
  /// How samples are spread over work-items (engine/kernel_shape.h). Where both are 0, the device
  /// has the shape of engine/shape_choice.h: the environment's, the tuned or the standard one.
  int lanesPerItem = 0;
  int samplesPerGroup = 0;
  FramePath path = FramePath::fused;
  /// Whether the device has to pass the self test (engine/self_test.h).
  bool selfTest = true;
  /// Told in words of every device that "auto" passes over because it failed.
  std::function<void(const std::string& reason)> onRefusal = {};
  /// Told in words of a file of tuned shapes that is ignored (engine/tuned_shapes.h).
  std::function<void(const std::string& warning)> onWarning = {};
};

/// Options that name a device of listDevices().
EngineOptions optionsFor(const DeviceDescription& device);

/// An engine that looks visibility up in `table`, or with none finds it exactly
/// (visibility/visibility_kind.h). Throws InputError for an unknown engine or device and for one
/// that fails the self test.
std::unique_ptr<Engine> makeEngine(const EngineOptions& options,
                                   std::shared_ptr<const SphereTable> table);

}  // namespace haarlight
