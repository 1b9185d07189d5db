#include <algorithm>
#include <span>
#include <vector>

#include "base/text_format.h"
#include "verify/gpu_check/gpu_check_record.h"
#include "verify/report/report_writers.h"
#include "verify/subjects.h"

namespace haarlight::verify {

namespace {

using Cells = std::vector<std::string>;

const Cells titles = [] {
  Cells cells{"visibility", "spheres", "terms", "level", "frames/s"};
  for (const NamedStage& stage : namedStages) cells.push_back(stage.name);
  return cells;
}();

/// Cells below their titles, to the right.
std::string tableLine(const Cells& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    constexpr std::size_t narrowest = 8;
    const std::size_t width = std::max(narrowest, titles[i].size());
    line += "  " + std::string(width - std::min(width, cells[i].size()), ' ') + cells[i];
  }
  return line + "\n";
}

std::string millisecondsText(double seconds) {
  return fixedText(1e3 * seconds, 3);
}

std::string budgetLine(const DeviceMeasurement& measurement) {
  const Budget& budget = *measurement.budget;
  return "  a GeForce 8800's budget " + std::string(budget.isKept() ? "is kept" : "is EXCEEDED") +
         ": " + countText(budget.memoryBytes) + " bytes, " + countText(budget.largestLocalBytes) +
         " bytes of local memory a group, " +
         countText(std::uint64_t(budget.itemsPerGroup), "item") + " a group\n";
}

std::string frameRateTable(std::span<const FrameRate> rates) {
  std::string text =
      "  frames per second with upload and read-back; milliseconds by stage\n" + tableLine(titles);
  for (const FrameRate& rate : rates) {
    const StageTimes& stages = rate.stageMedians;
    Cells cells{nameOf(rate.visibility), numberText(rate.spheres), numberText(rate.terms),
                rate.levels == 1 ? "I" : "II", fixedText(rate.timing.framesPerSecond(), 2)};
    for (const NamedStage& stage : namedStages)
      cells.push_back(millisecondsText(stages.*stage.seconds));
    text += tableLine(cells);
  }
  return text;
}

std::string measurementText(const DeviceMeasurement& measurement) {
  std::string text = "\n" + visible(joined({measurement.engine, measurement.device}, " · ")) + "\n";
  if (measurement.budget) text += budgetLine(measurement);
  if (!measurement.frameRates.empty()) text += frameRateTable(measurement.frameRates);
  if (!measurement.failure.empty()) text += "  FAILED: " + visible(measurement.failure) + "\n";
  return text;
}

std::string stepsText(std::span<const Step> steps) {
  std::string text = steps.empty() ? "" : "\nSteps\n";
  for (const Step& step : steps)
    text += "  " + visible(joined({step.name, nameOf(step.result), step.details}, ": ")) + "\n";
  return text;
}

}  // namespace

std::string textRecord(const GpuCheckRecord& record) {
  std::string text = textReport(record.report, false);
  for (const DeviceMeasurement& measurement : record.measurements)
    text += measurementText(measurement);
  text += stepsText(record.steps);
  if (!record.showsGpuRun()) text += "\n" + std::string(noGpuNote) + "\n";
  return text + (record.passes() ? "\nPASSED\n" : "\nFAILED\n");
}

}  // namespace haarlight::verify
