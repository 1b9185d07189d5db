#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/track.h"

namespace haarlight {

/// What was followed over which frames, and where.
struct TrackReport {
  std::string program;  ///< with its version
  std::string host;     ///< the machine
  std::string date;     ///< when it ended
  std::string scene;
  double framesPerSecond = 24;
  std::string method;  ///< whose radiance was compared; empty without a comparison
  std::vector<std::string> objects;
  std::vector<TrackFrame> frames;  ///< one at least, each with all objects
  bool interrupted = false;        ///< before the last frame asked for

  /// One line that says how well the moved spheres stand in for the meshes.
  std::string conclusion() const;
};

/// The figures over all frames, by name: covered_surface_lowest, silhouette_error, radius_ratio for
/// each object; plane_error; and moved_to_refitted where spheres were fitted anew.
nlohmann::ordered_json trackSummaryJson(const TrackReport& report);

/// One JSON object: program, host, date, scene, frames_per_second, method, interrupted, summary,
/// and frames with all measures by the names of measuresJson.
nlohmann::ordered_json trackJson(const TrackReport& report);

/// A line for each frame and object below a header, in columns.
std::string trackText(const TrackReport& report);

/// The figures over frames as plots in one SVG picture.
std::string trackSvg(const TrackReport& report);

/// A page of its own, without links to anything: conclusion, plots, table.
std::string trackHtml(const TrackReport& report);

/// Writes the report that the extension asks for, .json, .svg or .html. Throws InputError for
/// others, and when the file cannot be written.
void writeTrackReport(const std::filesystem::path& path, const TrackReport& report);

}  // namespace haarlight
