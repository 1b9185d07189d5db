#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "mesh/mesh_file.h"
#include "spheres/fit_spheres.h"

namespace haarlight {

/// What a fit was asked for, what it gave, and where it ran.
struct FitReport {
  std::string program;  ///< with its version
  std::string host;     ///< the machine
  std::string date;     ///< when the fit ended
  std::size_t requestedSpheres = 0;
  std::optional<double> maximumError;  ///< as in SphereFitOptions
  std::optional<double> timeLimit;     ///< the same
  const LoadedMesh& mesh;
  const SphereFit& fit;  ///< its set names the mesh

  /// Whether the fit ended by itself with what it was asked for.
  bool complete() const;
  /// One line that says how well the spheres stand in for the mesh.
  std::string conclusion() const;
};

/// Why a fit ended, in words, and as the JSON report has it.
std::string stopText(FitStop stop);
std::string stopName(FitStop stop);

/// One JSON object: program, host, date, mesh, requested, result (with the measures by the names of
/// measuresJson), history, warnings, spheres.
std::string fitReportJson(const FitReport& report);

/// A page of its own, without links to anything: conclusion, measures, the error over steps and
/// time, pictures of mesh and spheres from three sides.
std::string fitReportHtml(const FitReport& report);

/// Writes the report that the extension asks for, .json or .html. Throws InputError for others, and
/// when the file cannot be written.
void writeFitReport(const std::filesystem::path& path, const FitReport& report);

}  // namespace haarlight
