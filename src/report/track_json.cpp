#include "render/track_summary.h"
#include "report/measures_json.h"
#include "report/track_report.h"

namespace haarlight {

namespace {

using Json = nlohmann::ordered_json;

Json errorJson(const ImageError& error) {
  return {{"rmse", error.rootMeanSquare},
          {"mean", error.referenceMean},
          {"rmse_relative_to_mean_percent", 100 * error.relativeRootMeanSquare}};
}

Json objectJson(const std::string& name, const ObjectFrame& object) {
  const RadiusRatios& radii = object.radii;
  Json json{{"name", name}, {"moved", measuresJson(object.moved)}};
  json["radius_ratio"] = {
      {"smallest", radii.smallest}, {"mean", radii.mean}, {"largest", radii.largest}};
  if (object.refitted) json["refitted"] = measuresJson(*object.refitted);
  return json;
}

Json frameJson(const TrackReport& report, const TrackFrame& frame) {
  Json json{{"frame", frame.frame}, {"seconds", frame.seconds}};
  for (std::size_t i = 0; i < report.objects.size(); ++i)
    json["objects"].push_back(objectJson(report.objects[i], frame.objects[i]));
  if (!frame.plane) return json;
  json["plane"]["moved"] = errorJson(frame.plane->moved);
  if (frame.plane->refitted) json["plane"]["refitted"] = errorJson(*frame.plane->refitted);
  return json;
}

Json refitJson(const RefitSummary& refits) {
  return {{"frames", refits.frames},
          {"mean_moved_percent", 100 * refits.meanMoved},
          {"mean_refitted_percent", 100 * refits.meanRefitted},
          {"ratio_of_means", refits.ratioOfMeans},
          {"mean_ratio", refits.meanRatio}};
}

Json objectSummaryJson(const std::string& name, const ObjectSummary& object) {
  return {{"name", name},
          {"covered_surface_lowest", object.lowestCoverage},
          {"covered_surface_lowest_frame", object.lowestCoverageFrame},
          {"covered_surface_standard_error", object.coverageStandardError},
          {"silhouette_error_mean", object.meanSilhouetteError},
          {"silhouette_error_largest", object.largestSilhouetteError},
          {"radius_ratio_smallest", object.smallestRadiusRatio},
          {"radius_ratio_largest", object.largestRadiusRatio}};
}

}  // namespace

Json trackSummaryJson(const TrackReport& report) {
  const TrackSummary summary = summarize(report.frames);
  Json json{{"frames_measured", report.frames.size()}, {"surface_points", trackPoints}};
  if (report.interrupted) json["interrupted"] = true;
  for (std::size_t i = 0; i < report.objects.size(); ++i) {
    json["object"].push_back(objectSummaryJson(report.objects[i], summary.objects[i]));
    if (!summary.silhouetteRefits.empty())
      json["object"].back()["silhouette_moved_to_refitted"] =
          refitJson(summary.silhouetteRefits[i]);
  }
  if (const auto& plane = summary.plane)
    json["plane_error"] = {{"method", report.method},
                           {"reference", "pixel-mesh"},
                           {"mean_percent", 100 * plane->mean},
                           {"largest_percent", 100 * plane->largest},
                           {"largest_frame", plane->largestFrame}};
  if (summary.planeRefits)
    json["plane_error"]["moved_to_refitted"] = refitJson(*summary.planeRefits);
  return json;
}

Json trackJson(const TrackReport& report) {
  Json json{{"program", report.program},
            {"host", report.host},
            {"date", report.date},
            {"scene", report.scene},
            {"frames_per_second", report.framesPerSecond},
            {"interrupted", report.interrupted},
            {"summary", trackSummaryJson(report)}};
  for (const TrackFrame& frame : report.frames) json["frames"].push_back(frameJson(report, frame));
  return json;
}

}  // namespace haarlight
