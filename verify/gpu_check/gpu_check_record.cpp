#include "verify/gpu_check/gpu_check_record.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace haarlight::verify {

namespace {

constexpr std::array<std::pair<StepResult, const char*>, 3> stepResultNames{
    {{StepResult::passed, "passed"},
     {StepResult::failed, "failed"},
     {StepResult::notRun, "not run"}}};

bool isGpu(const DeviceDescription& device) {
  return (device.engine == "cuda" || device.engine == "opencl") && !device.isCpu;
}

}  // namespace

std::string nameOf(StepResult result) {
  return std::ranges::find(stepResultNames, result, [](auto& entry) { return entry.first; })
      ->second;
}

StepResult stepResult(const std::string& name) {
  for (const auto& [result, resultName] : stepResultNames)
    if (name == resultName) return result;
  throw InputError("a step has passed, failed or not run, not '" + name + "'");
}

bool GpuCheckRecord::showsGpuRun() const {
  return std::ranges::any_of(devices, [&](const DeviceDescription& device) {
    return isGpu(device) && std::ranges::any_of(report.rows, [&](const Row& row) {
             return row.compared > 0 && row.engine == device.engine && row.device == device.name;
           });
  });
}

bool GpuCheckRecord::passes() const {
  const auto worked = [](const DeviceMeasurement& m) { return m.failure.empty(); };
  const auto noFailure = [](const Step& step) { return step.result != StepResult::failed; };
  return report.agrees() && std::ranges::all_of(measurements, worked) &&
         std::ranges::all_of(steps, noFailure);
}

}  // namespace haarlight::verify
