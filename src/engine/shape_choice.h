#pragma once

#include "engine/devices.h"
#include "engine/tuned_shapes.h"

namespace haarlight {

/// Who has the say about a device's shape, the last word first.
enum class ShapeSource { options, environment, tuned, standard };

struct ShapeChoice {
  KernelShape shape;
  ShapeSource source = ShapeSource::standard;
};

/// On CPUs under OpenCL items of 32 lanes, in groups of one sample; else items of one lane, in
/// groups of four samples.
KernelShape standardShape(const DeviceDescription& device);

/// The shape that a device is opened in:
///
///   options      what they say; of what they leave open, what is standard for the rest
///   environment  what HAARLIGHT_WORK_SHAPE is: LANESxSAMPLES such as 32x1, for devices whose
///                kernels come in that shape; "default" for what is standard; null or empty: it
///                says nothing
///   tuned        what `tuned` has for the device
///   standard     standardShape()
///
/// Throws InputError for options that the engine's kernels do not come in, and for an environment
/// that no kernels do.
ShapeChoice chooseShape(const EngineOptions& options, const DeviceDescription& device,
                        const char* environment, const TunedShapes& tuned);

/// The same with the environment and the cache folder as they are.
ShapeChoice chooseShape(const EngineOptions& options, const DeviceDescription& device);

/// The environment variable.
inline constexpr const char* shapeVariable = "HAARLIGHT_WORK_SHAPE";

}  // namespace haarlight
