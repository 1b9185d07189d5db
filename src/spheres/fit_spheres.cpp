#include "spheres/fit_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/error.h"
#include "mesh/flatness.h"
#include "mesh/mesh_measures.h"
#include "mesh/solid_repair.h"
#include "spheres/cover_fit.h"
#include "spheres/fit_monitor.h"
#include "spheres/fit_problem.h"
#include "spheres/shadow_fit.h"
#include "spheres/silhouette_error.h"
#include "spheres/sphere_measures.h"
#include "spheres/unit_frame.h"

namespace haarlight {

namespace {

constexpr std::size_t measureSamples = 100000;

/// More spheres are smaller and so need a finer grid and denser points.
int gridCells(std::size_t count) {
  return std::clamp(static_cast<int>(16 * std::sqrt(double(count))), 64, 192);
}
std::size_t coarsePointCount(std::size_t count) {
  const std::size_t forFew = std::min<std::size_t>(3000 + 300 * count, 20000);
  return std::min<std::size_t>(std::max(forFew, 60 * count), 80000);
}
std::size_t densePointCount(std::size_t count) {
  return std::clamp<std::size_t>(6000 * count, 100000, 400000);
}

void checkRequest(const TriangleMesh& mesh, std::size_t count) {
  if (count < 1 || count > maximumFittedSpheres)
    throw InputError("the number of spheres must be from 1 to " +
                     std::to_string(maximumFittedSpheres) + ", not " + std::to_string(count));
  if (mesh.triangles.empty() || !(surfaceArea(mesh) > 0))
    throw InputError("spheres cannot be fitted to a mesh without triangles; load one with some");
  if (liesInPlane(mesh))
    throw InputError(
        "spheres cannot be fitted to a mesh that lies in one plane; give it some thickness");
}

/// Vertices, centres of triangles, and points spread over the surface.
std::vector<glm::vec3> pointsToCover(const TriangleMesh& mesh, std::size_t count,
                                     std::uint64_t seed) {
  std::vector<glm::vec3> points = sampleSurface(mesh, densePointCount(count), seed + 1);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    points.emplace_back((a + b + c) / 3.0);
  }
  points.insert(points.end(), mesh.positions.begin(), mesh.positions.end());
  return points;
}

/// One mesh, its inside and its frame, for fits with different numbers of spheres.
class Fitter {
 public:
  Fitter(const TriangleMesh& mesh, const SphereFitOptions& options)
      : mesh_(mesh), frame_(mesh), options_(options), monitor_(options) {}

  std::vector<Sphere> fit(std::size_t count) {
    const bool cover = options_.objective == FitObjective::cover;
    const FitProblem problem = problemFor(count, cover);
    const std::vector<Ball> balls = cover ? fitCover(problem, count, options_.seed, monitor_)
                                          : fitShadow(problem, count, options_.seed, monitor_);
    std::vector<Sphere> spheres;
    for (const Ball& ball : balls)
      spheres.push_back({glm::vec3(frame_.fromUnit(ball.center)),
                         std::max(static_cast<float>(ball.radius / frame_.scale()),
                                  std::numeric_limits<float>::min())});
    // Centres and radii have been rounded.
    return cover ? grownToCover(spheres, pointsToCover(mesh_, count, options_.seed)) : spheres;
  }

  /// Doubles the number until the error, as measured afterwards, is reached; then halves the steps
  /// back to where it is not.
  std::vector<Sphere> fitWithin(double maximumError, std::size_t most) {
    std::size_t tooFew = 0, enough = std::min<std::size_t>(8, most);
    std::vector<Sphere> best = fitNext(enough);
    bool reached = errorOf(best) <= maximumError;
    while (!reached && enough < most && !monitor_.mustStop()) {
      tooFew = std::exchange(enough, std::min(2 * enough, most));
      best = fitNext(enough);
      reached = errorOf(best) <= maximumError;
    }
    if (!reached) return best;
    monitor_.reachError();
    while (enough - tooFew > std::max<std::size_t>(1, enough / 16) && !monitor_.mustStop()) {
      const std::size_t middle = (enough + tooFew) / 2;
      std::vector<Sphere> spheres = fitNext(middle);
      reached = errorOf(spheres) <= maximumError;
      (reached ? enough : tooFew) = middle;
      if (reached) best = std::move(spheres);
    }
    return best;
  }

  FitMonitor& monitor() { return monitor_; }

 private:
  /// The measure that the objective makes small. Where a mesh encloses nothing, a cover has none
  /// but what the fit itself takes.
  double errorOf(std::span<const Sphere> spheres) const {
    if (options_.objective == FitObjective::shadow) return silhouetteError(mesh_, spheres).mean;
    const auto volumes = volumeMeasures(mesh_, spheres, measureSamples, 0);
    return volumes ? volumes->summedOutside : monitor_.lastError();
  }

  /// One fit of a number that is not known yet: half of what is left of the progress.
  std::vector<Sphere> fitNext(std::size_t count) {
    monitor_.beginHalfOfRest();
    return fit(count);
  }

  FitProblem problemFor(std::size_t count, bool cover) const {
    TriangleMesh mesh = frame_.toUnit(mesh_);
    SolidGrid solid(mesh, gridCells(count));
    std::vector<glm::vec3> surface = sampleSurface(mesh, coarsePointCount(count), options_.seed);
    std::vector<glm::vec3> interior, demanded;
    if (cover) interior = solid.insidePoints(surface.size() / 2);
    if (cover) demanded = pointsToCover(mesh, count, options_.seed);
    return {std::move(mesh), std::move(solid), std::move(surface), std::move(interior),
            std::move(demanded)};
  }

  const TriangleMesh& mesh_;
  UnitFrame frame_;
  const SphereFitOptions& options_;
  FitMonitor monitor_;
};

}  // namespace

SphereFit fitSpheres(const TriangleMesh& mesh, std::size_t count, const SphereFitOptions& options) {
  checkRequest(mesh, count);
  SolidRepair repair = prepareSolid(mesh);
  Fitter fitter(repair.mesh, options);
  SphereFit fit;
  fit.set.spheres =
      options.maximumError ? fitter.fitWithin(*options.maximumError, count) : fitter.fit(count);
  fit.set.meshHash = meshHash(mesh);
  fit.set.objective = options.objective;
  fit.set.measures = measureSpheres(repair.mesh, fit.set.spheres, measureSamples);
  fit.set.method = options.objective == FitObjective::cover
                       ? "flood fill, Powell, teleportation (Wang et al. 2006)"
                       : "silhouettes, Powell, teleportation";
  fit.set.seed = options.seed;
  fit.history = fitter.monitor().takeHistory();
  fit.stop = fitter.monitor().stop();
  fit.seconds = fitter.monitor().seconds();
  fit.warnings = std::move(repair.warnings);
  return fit;
}

}  // namespace haarlight
