#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/devices.h"
#include "engine/kernel_shape.h"

namespace haarlight::benchmark {

/// Median seconds of a frame on the fused path.
struct ShapeSeconds {
  double exact = 0;
  double table = 0;
};

/// What a shape of work was found to be worth.
struct ShapeTiming {
  KernelShape shape;
  ShapeSeconds seconds;
  /// Why it cannot be used, such as a self test that fails; empty when it can.
  std::string failure;
};

/// Measures a shape; throws what is told as the failure.
using TimeShape = std::function<ShapeSeconds(const KernelShape&)>;
using Interrupted = std::function<bool()>;

/// Measures the shapes one after the other. Once `interrupted` says true, only those that were
/// finished before are there.
std::vector<ShapeTiming> timeShapes(std::span<const KernelShape> shapes, const TimeShape& time,
                                    const Interrupted& interrupted);

/// The least part of a frame's time, of both kinds of visibility together, that another shape than
/// the standard one has to save: less may be chance.
inline constexpr double worthwhileSaving = 0.05;

/// The shape to use: of those without a failure the one with the least geometric mean of both
/// times, the first of equal ones; but the `standard` one where that saves too little. Null when
/// all fail.
const ShapeTiming* chosenShape(std::span<const ShapeTiming> timings, const KernelShape& standard);

inline constexpr std::size_t paperSamples = 128 * 128;

/// What a shape is measured on: the paper's frame (verify/cases/paper_frame.h) with 64 spheres, 200
/// terms and two levels.
struct TuningFrames {
  std::shared_ptr<const SphereTable> table;
  std::size_t frames = 10;
  /// The first ones of the frame's.
  std::size_t samples = paperSamples;
  std::size_t warmUpFrames = 2;
  Interrupted interrupted = [] { return false; };
};

/// Opens the device in the shape, with exact visibility and with the table in turn; each has to
/// pass the self test. Throws what makeEngine does. Means nothing once it was interrupted.
ShapeSeconds timePaperFrame(const DeviceDescription& device, const KernelShape& shape,
                            const TuningFrames& frames);

}  // namespace haarlight::benchmark
