#pragma once

#include <span>
#include <string>
#include <vector>

#include "benchmark/ceilings.h"
#include "benchmark/frame_model.h"
#include "benchmark/inputs.h"

namespace haarlight::benchmark {

struct Record;

/// The least time in which a machine with these ceilings can do a stage's work.
struct TimeLimit {
  double seconds = 0;
  /// What the time goes to: "operations", or the memory that the bytes come from.
  std::string boundBy;
};

/// The largest of: operations over the fastest rate; for each memory, the bytes that come from it
/// or from beyond over the fastest of its rates.
TimeLimit timeLimit(const StageWork& work, const Ceilings& ceilings);

struct StageRoofline {
  StageWork work;
  TimeLimit limit;
  /// Median of the row's frames.
  double measuredSeconds = 0;

  /// The part of the time that the ceilings account for.
  double share() const { return limit.seconds / measuredSeconds; }
};

struct RowRoofline {
  /// Index into the record's rows.
  std::size_t row = 0;
  FrameCounts counts;
  std::vector<StageRoofline> stages;

  /// Of all stages, one after the other.
  double leastSeconds() const;
};

/// A machine's ceilings and how near to them frames come.
struct Roofline {
  Ceilings ceilings;
  std::vector<RowRoofline> rows;
};

/// What a row's stages could take at least, beside what they took; stages that were not timed are
/// left out.
RowRoofline rooflineOf(const Record& record, std::size_t row, const FrameCounts& counts,
                       const Ceilings& ceilings);

/// Rows that run on the host's processor, whose ceilings these are, at the paper's 64 spheres, 200
/// terms and two levels, else at the last setting that was measured. `table` is needed where one of
/// them has it.
Roofline measureRoofline(const Record& record, const Inputs& inputs, const SphereTable* table,
                         const CeilingPlan& plan, const Progress& progress);

}  // namespace haarlight::benchmark
