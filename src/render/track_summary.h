#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "render/track.h"

namespace haarlight {

/// One object over all frames.
struct ObjectSummary {
  double lowestCoverage = 0;
  int lowestCoverageFrame = 0;
  double coverageStandardError = 0;  ///< at most, of the lowest
  double meanSilhouetteError = 0;
  double largestSilhouetteError = 0;
  double smallestRadiusRatio = 1;
  double largestRadiusRatio = 1;
};

/// The plane's error relative to the mean over all frames.
struct PlaneSummary {
  double mean = 0;
  double largest = 0;
  int largestFrame = 0;
};

/// Moved spheres and those fitted anew, over the frames that have both.
struct RefitSummary {
  std::size_t frames = 0;
  double meanMoved = 0;
  double meanRefitted = 0;
  double ratioOfMeans = 0;  ///< meanMoved / meanRefitted
  double meanRatio = 0;     ///< mean over the frames of moved / refitted
};

struct TrackSummary {
  std::vector<ObjectSummary> objects;
  std::optional<PlaneSummary> plane;
  /// Of mean silhouette errors, by object; empty when nothing was fitted anew.
  std::vector<RefitSummary> silhouetteRefits;
  std::optional<RefitSummary> planeRefits;
};

/// Needs a frame.
TrackSummary summarize(std::span<const TrackFrame> frames);

}  // namespace haarlight
