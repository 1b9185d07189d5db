#pragma once

#include <functional>
#include <span>
#include <vector>

#include "benchmark/inputs.h"
#include "benchmark/record.h"

namespace haarlight::benchmark {

/// How often things are done, and who is told and asked meanwhile.
struct Effort {
  std::size_t frames = 20;
  std::size_t warmUpFrames = 2;
  Progress progress;
  /// Asked between frames; once it says true, what has been measured so far is the result.
  std::function<bool()> interrupted = [] { return false; };

  /// Parts that a row's frames are measured in.
  std::size_t rounds() const { return std::min<std::size_t>(frames, 5); }
};

/// Every combination, in this order of importance.
std::vector<Setting> settingsOf(std::span<const int> spheres, std::span<const int> terms,
                                std::span<const int> levels);

/// Measures every subject at every setting, whose spheres `inputs` has. Frames are measured in
/// rounds over all rows, so that a machine that slows down slows all rows alike. Rows without a
/// frame, after an interruption, are left out.
std::vector<Row> measureRows(std::span<const OpenSubject> subjects, const Inputs& inputs,
                             std::span<const Setting> settings, const Effort& effort);

}  // namespace haarlight::benchmark
