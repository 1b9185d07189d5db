#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "spheres/sphere_set.h"

namespace haarlight {

/// One step of a fit, for plots and progress.
struct FitStep {
  std::string phase;        ///< what the fit was doing, such as "refine" or "teleport"
  double seconds = 0;       ///< since the start
  std::size_t spheres = 0;  ///< in the best set so far
  /// Of the best set so far, as the fit itself estimates it: E of Wang et al. for `cover`, which
  /// rises a little as more points are taken up in the end; for `shadow` the mean silhouette error
  /// and the mean part of the sky that spheres take from the mesh's own surface.
  double error = 0;
};

/// Where a fit stands.
struct FitProgress {
  double finished = 0;  ///< 0 … 1
  double error = 0;     ///< as in FitStep
};

enum class FitStop { converged, errorReached, timeLimit, cancelled };

struct SphereFitOptions {
  FitObjective objective = FitObjective::shadow;
  /// With this, the count is the most spheres to use, and about as few are used as reach the error:
  /// SphereMeasures::outsideVolumeRatio for `cover`, the mean silhouette error for `shadow`.
  std::optional<double> maximumError;
  /// Seconds after which the best set so far is taken. A result that was cut off depends on the
  /// speed of the machine.
  std::optional<double> timeLimit;
  std::uint64_t seed = 0;
  /// Called now and then; from several threads, but one at a time.
  std::function<void(const FitProgress&)> progress;
  /// Asked now and then; once it says true, the best set so far is taken.
  std::function<bool()> cancelled;
};

constexpr std::size_t maximumFittedSpheres = 4096;

struct SphereFit {
  SphereSet set;
  std::vector<FitStep> history;  ///< in order of time; the first is the start, the last the result
  FitStop stop = FitStop::converged;
  double seconds = 0;
  /// One line each: what is unusual in the mesh and what was done about it.
  std::vector<std::string> warnings;
};

/// Stands in for a mesh by up to `count` spheres; fewer only where no further sphere would help.
/// It works on the mesh as prepareSolid leaves it: without stray triangles, for one. A cover holds
/// that one's vertices, centres of triangles and points spread densely over the surface, in float
/// arithmetic. Where a mesh encloses nothing, a cover keeps the volume of the spheres small.
///
/// The result depends on mesh, count, objective and seed alone, not on the number of threads;
/// meshName is left empty. Throws InputError when count is not from 1 to maximumFittedSpheres, or
/// the mesh has no triangle with an area or lies in one plane.
SphereFit fitSpheres(const TriangleMesh& mesh, std::size_t count,
                     const SphereFitOptions& options = {});

}  // namespace haarlight
