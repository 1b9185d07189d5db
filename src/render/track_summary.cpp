#include "render/track_summary.h"

#include <algorithm>
#include <cmath>

namespace haarlight {

namespace {

ObjectSummary objectSummary(std::span<const TrackFrame> frames, std::size_t index) {
  const auto of = [&](const TrackFrame& frame) -> const ObjectFrame& {
    return frame.objects[index];
  };
  const ObjectFrame& first = of(frames.front());
  ObjectSummary summary{.lowestCoverage = first.moved.coveredFraction,
                        .lowestCoverageFrame = frames.front().frame,
                        .smallestRadiusRatio = first.radii.smallest,
                        .largestRadiusRatio = first.radii.largest};
  for (const TrackFrame& frame : frames) {
    const ObjectFrame& object = of(frame);
    if (object.moved.coveredFraction < summary.lowestCoverage) {
      summary.lowestCoverage = object.moved.coveredFraction;
      summary.lowestCoverageFrame = frame.frame;
    }
    const double error = object.moved.silhouette->mean;
    summary.meanSilhouetteError += error / double(frames.size());
    summary.largestSilhouetteError = std::max(summary.largestSilhouetteError, error);
    summary.smallestRadiusRatio = std::min(summary.smallestRadiusRatio, object.radii.smallest);
    summary.largestRadiusRatio = std::max(summary.largestRadiusRatio, object.radii.largest);
  }
  const double covered = summary.lowestCoverage;
  summary.coverageStandardError = std::sqrt(covered * (1 - covered) / trackPoints);
  return summary;
}

PlaneSummary planeSummary(std::span<const TrackFrame> frames) {
  PlaneSummary summary{0, 0, frames.front().frame};
  for (const TrackFrame& frame : frames) {
    const double error = frame.plane->moved.relativeRootMeanSquare;
    summary.mean += error / double(frames.size());
    if (error <= summary.largest) continue;
    summary.largest = error;
    summary.largestFrame = frame.frame;
  }
  return summary;
}

/// `errors` are those with moved spheres and those with spheres fitted anew.
RefitSummary refitSummary(std::span<const glm::dvec2> errors) {
  RefitSummary summary{errors.size()};
  const double count = double(errors.size());
  for (const glm::dvec2& error : errors) {
    summary.meanMoved += error.x / count;
    summary.meanRefitted += error.y / count;
    summary.meanRatio += error.x / error.y / count;
  }
  summary.ratioOfMeans = summary.meanMoved / summary.meanRefitted;
  return summary;
}

std::vector<glm::dvec2> silhouetteErrors(std::span<const TrackFrame> frames, std::size_t index) {
  std::vector<glm::dvec2> errors;
  for (const TrackFrame& frame : frames)
    if (const ObjectFrame& object = frame.objects[index]; object.refitted)
      errors.emplace_back(object.moved.silhouette->mean, object.refitted->silhouette->mean);
  return errors;
}

std::vector<glm::dvec2> planeErrors(std::span<const TrackFrame> frames) {
  std::vector<glm::dvec2> errors;
  for (const TrackFrame& frame : frames)
    if (frame.plane && frame.plane->refitted)
      errors.emplace_back(frame.plane->moved.relativeRootMeanSquare,
                          frame.plane->refitted->relativeRootMeanSquare);
  return errors;
}

}  // namespace

TrackSummary summarize(std::span<const TrackFrame> frames) {
  TrackSummary summary;
  for (std::size_t i = 0; i < frames.front().objects.size(); ++i) {
    summary.objects.push_back(objectSummary(frames, i));
    if (const auto errors = silhouetteErrors(frames, i); !errors.empty())
      summary.silhouetteRefits.push_back(refitSummary(errors));
  }
  if (frames.front().plane) summary.plane = planeSummary(frames);
  if (const auto errors = planeErrors(frames); !errors.empty())
    summary.planeRefits = refitSummary(errors);
  return summary;
}

}  // namespace haarlight
