#pragma once

#include <array>
#include <vector>

#include "base/frame_timing.h"

namespace haarlight {

/// How shade() goes from spheres to radiance; the bits are the same.
enum class FramePath {
  /// In one kernel, which writes nothing but the radiance.
  fused,
  /// In the paper's three steps, each with its own kernel.
  staged
};

/// Seconds spent in each step of one shade() call, summed over batches. A path takes none for the
/// steps that it does not have.
struct StageTimes {
  double upload = 0;
  /// The fused path's kernels, or those of exponentiation or of transfer.
  double fused = 0;
  double merge = 0;
  double transform = 0;
  double tripleProduct = 0;
  double readBack = 0;
  /// From call to return.
  double total = 0;
};

/// A step that is timed on its own, as reports name it.
struct NamedStage {
  const char* name;
  double StageTimes::*seconds;
};

/// In the order of a frame, without the total.
inline constexpr std::array namedStages{
    NamedStage{"upload", &StageTimes::upload},
    NamedStage{"fused", &StageTimes::fused},
    NamedStage{"merge", &StageTimes::merge},
    NamedStage{"transform", &StageTimes::transform},
    NamedStage{"triple_product", &StageTimes::tripleProduct},
    NamedStage{"read_back", &StageTimes::readBack},
};

inline StageTimes operator-(StageTimes a, const StageTimes& b) {
  for (const NamedStage& stage : namedStages) a.*stage.seconds -= b.*stage.seconds;
  a.total -= b.total;
  return a;
}

/// The median of each stage, and of the total, on its own. Needs a frame.
inline StageTimes stageMedians(const std::vector<StageTimes>& frames) {
  StageTimes medians;
  const auto take = [&](double StageTimes::*stage) {
    std::vector<double> seconds;
    for (const StageTimes& frame : frames) seconds.push_back(frame.*stage);
    medians.*stage = median(seconds);
  };
  for (const NamedStage& stage : namedStages) take(stage.seconds);
  take(&StageTimes::total);
  return medians;
}

}  // namespace haarlight
