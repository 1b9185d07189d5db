#pragma once

#include <array>
#include <memory>

#include "verify/expected.h"
#include "verify/gpu_check/gpu_check_record.h"
#include "verify/run.h"

namespace haarlight::verify {

/// The rows and columns of the paper's table (method.md §6).
inline constexpr std::array paperSphereCounts{32, 64, 96, 128};
inline constexpr std::array paperSettings{Setting{50, 1}, Setting{50, 2}, Setting{200, 1},
                                          Setting{200, 2}};

struct GpuCheckOptions {
  RunOptions run;
  /// Whether budgets and frame rates are measured.
  bool measures = true;
};

/// Compares the engines (verify/run.h), then measures every device. Steps, program, host and date
/// are left to the caller. Throws InputError for an unknown engine.
GpuCheckRecord checkGpus(const GpuCheckOptions& options, std::shared_ptr<const SphereTable> table);

/// Shades `frame` again and again with what `engine` has been given by setShading; only timing,
/// receivers and stages of the result are set.
FrameRate measureFrame(Engine& engine, const Case& frame);

}  // namespace haarlight::verify
