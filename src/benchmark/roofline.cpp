#include "benchmark/roofline.h"

#include <algorithm>
#include <optional>

#include "benchmark/record.h"

namespace haarlight::benchmark {

namespace {

bool isOnHost(const Subject& subject) {
  return subject.device.isCpu || subject.device.engine == "reference";
}

std::vector<std::size_t> rowsOnHost(const Record& record) {
  constexpr Setting paper;
  const bool hasPaper = std::ranges::find(record.rows, paper, &Row::setting) != record.rows.end();
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < record.rows.size(); ++i) {
    const Row& row = record.rows[i];
    if (isOnHost(record.subjects[row.subject].subject) &&
        row.setting == (hasPaper ? paper : record.rows.back().setting))
      rows.push_back(i);
  }
  return rows;
}

FrameCounts countRow(const Row& row, VisibilityKind visibility, const Inputs& inputs,
                     const SphereTable* table) {
  const auto fitted = std::ranges::find(inputs.scenes, row.setting.spheres, &FittedScene::spheres);
  const ShadingTables tables =
      buildShadingTables(inputs.light(), {.terms = row.setting.terms, .levels = row.setting.levels},
                         countLobes(inputs.receivers.lobes));
  return countFrame(fitted->scene.blockerSpheres(), inputs.receivers,
                    visibility == VisibilityKind::table ? table : nullptr, tables.squareCount());
}

/// How far from the processor a working set lies.
std::size_t levelOf(double workingSet, const std::vector<MemoryCeiling>& memory) {
  const auto holds = [&](const MemoryCeiling& level) { return workingSet <= level.holdsBytes; };
  return std::size_t(std::ranges::find_if(memory, holds) - memory.begin());
}

}  // namespace

TimeLimit timeLimit(const StageWork& work, const Ceilings& ceilings) {
  TimeLimit limit{work.operations / ceilings.operations(), "operations"};
  for (std::size_t level = 0; level < ceilings.memory.size(); ++level) {
    double bytes = 0;
    for (const Traffic& part : work.traffic)
      if (levelOf(part.workingSet, ceilings.memory) >= level) bytes += part.bytes;
    const double seconds = bytes / ceilings.memory[level].fastest();
    if (seconds > limit.seconds) limit = {seconds, ceilings.memory[level].name};
  }
  return limit;
}

double RowRoofline::leastSeconds() const {
  double sum = 0;
  for (const StageRoofline& stage : stages) sum += stage.limit.seconds;
  return sum;
}

RowRoofline rooflineOf(const Record& record, std::size_t row, const FrameCounts& counts,
                       const Ceilings& ceilings) {
  const Row& measured = record.rows[row];
  const Subject& subject = record.subjects[measured.subject].subject;
  RowRoofline roofline{row, counts, {}};
  for (const StageWork& work : frameWork(counts, subject.visibility, subject.path))
    if (const double seconds = measured.stageMedians.*work.stage; seconds > 0)
      roofline.stages.push_back({work, timeLimit(work, ceilings), seconds});
  return roofline;
}

Roofline measureRoofline(const Record& record, const Inputs& inputs, const SphereTable* table,
                         const CeilingPlan& plan, const Progress& progress) {
  Roofline roofline{measureCeilings(plan, progress), {}};
  std::optional<FrameCounts> exact, looked;
  for (const std::size_t i : rowsOnHost(record)) {
    const Row& row = record.rows[i];
    const VisibilityKind visibility = record.subjects[row.subject].subject.visibility;
    auto& counts = visibility == VisibilityKind::table ? looked : exact;
    if (!counts) counts = countRow(row, visibility, inputs, table);
    roofline.rows.push_back(rooflineOf(record, i, *counts, roofline.ceilings));
  }
  return roofline;
}

}  // namespace haarlight::benchmark
