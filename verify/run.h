#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verify/cases/case.h"
#include "verify/injection.h"
#include "verify/report/report.h"
#include "visibility/sphere_table.h"

namespace haarlight::verify {

struct RunOptions {
  /// Engines to compare with the reference; empty: all on all devices.
  std::vector<std::string> engines;
  /// Whether the known answers are asked, of the reference too.
  bool knownCases = true;
  std::size_t randomCases = 500;
  std::uint64_t seed = 1;
  /// Further cases: scenes, or one to replay.
  std::vector<Case> cases;
  std::optional<Injection> injection;
  /// Whether a failing case is cut down to what is needed to fail.
  bool shrinkFailure = false;
  /// Told what is going on and which part (0 … 1) of it is done.
  std::function<void(const std::string& task, double finished)> progress;
};

struct RunResult {
  Report report;
  /// The first case that an engine got wrong, cut down (RunOptions::shrinkFailure).
  std::optional<Case> failingCase;
};

/// Asks every engine and the reference all questions. Throws InputError for an unknown engine.
RunResult run(const RunOptions& options, std::shared_ptr<const SphereTable> table);

}  // namespace haarlight::verify
