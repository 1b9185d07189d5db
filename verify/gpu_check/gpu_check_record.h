#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/frame_timing.h"
#include "engine/devices.h"
#include "verify/cases/paper_frame.h"
#include "verify/report/report.h"
#include "visibility/visibility_kind.h"

namespace haarlight::verify {

/// How fast the paper's frame is rendered at one setting of the paper's table (method.md §6).
struct FrameRate {
  VisibilityKind visibility = VisibilityKind::exact;
  int spheres = 0, terms = 0, levels = 0;
  std::size_t receivers = 0;
  /// Wall-clock time of Engine::shade, upload of spheres and receivers and read-back included.
  FrameTiming timing;
  /// The median of each stage on its own.
  StageTimes stageMedians;
};

/// What one engine needs of one device, and how fast it is there.
struct DeviceMeasurement {
  std::string engine, device;
  /// In the shape for GPUs, one lane an item, with the sphere table.
  std::optional<Budget> budget;
  /// Empty for emulations, whose speed says nothing.
  std::vector<FrameRate> frameRates;
  /// Why it ended early; empty when it did not.
  std::string failure;
};

enum class StepResult { passed, failed, notRun };

/// "passed", "failed", "not run". The reverse throws InputError for another word.
std::string nameOf(StepResult result);
StepResult stepResult(const std::string& name);

/// What became of a program that was run beside this one: tests, compute-sanitizer.
struct Step {
  std::string name;
  StepResult result = StepResult::notRun;
  /// What it counted, or why it failed or was not run; may be empty.
  std::string details;
};

/// Everything that is found out about haarlight on a machine with a GPU (scripts/gpu-check).
struct GpuCheckRecord {
  /// Also names program, host and date.
  Report report;
  /// As the NVIDIA driver names itself; empty without one.
  std::string nvidiaDriver;
  std::vector<DeviceDescription> devices;
  std::vector<DeviceMeasurement> measurements;
  std::vector<Step> steps;

  /// Whether anything was compared on a GPU.
  bool showsGpuRun() const;
  /// Whether engines agree, every device could be measured, and no step failed.
  bool passes() const;
};

/// What a record without a GPU run says of itself.
inline constexpr const char* noGpuNote = "no GPU: this record shows no GPU run";

/// One JSON object, described in docs/verification.md.
std::string jsonRecord(const GpuCheckRecord& record);

/// The report's table, then budgets, frames per second and steps.
std::string textRecord(const GpuCheckRecord& record);

}  // namespace haarlight::verify
