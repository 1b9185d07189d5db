#include "spheres/fit_spheres.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "mesh/mesh_measures.h"
#include "spheres/point_clusters.h"
#include "spheres/solid_grid.h"
#include "spheres/sphere_cover.h"
#include "spheres/sphere_measures.h"
#include "spheres/unit_frame.h"

namespace haarlight {

namespace {

constexpr int lastRefits = 3;
constexpr std::size_t fewSpheres = 128;

/// One way to start. The results differ by some percent, more so for few spheres, where a start
/// takes little time.
struct Variant {
  std::string name;
  std::size_t count;
  bool withInterior;
  std::uint64_t seed;
};

std::vector<Variant> variantsFor(std::size_t count, std::uint64_t seed) {
  std::vector<Variant> variants = {{"surface clusters", count, false, seed},
                                   {"solid clusters", count, true, seed}};
  if (count <= fewSpheres) {
    variants.push_back({"surface clusters", count, false, seed + 1});
    variants.push_back({"solid clusters", count, true, seed + 1});
  }
  variants.push_back({"one sphere", 1, false, seed});
  return variants;
}

int exchangeRounds(std::size_t count) {
  return count <= fewSpheres ? 5 : 3;
}

/// More spheres are smaller and so need a finer grid and denser points.
int gridCells(std::size_t count) {
  return std::min(160, 32 + static_cast<int>(2 * std::sqrt(static_cast<double>(count))));
}
std::size_t coarsePointCount(std::size_t count) {
  const std::size_t forFew = std::min<std::size_t>(3000 + 300 * count, 20000);
  return std::min<std::size_t>(std::max(forFew, 60 * count), 80000);
}
std::size_t densePointCount(std::size_t count) {
  return std::clamp<std::size_t>(2000 * count, 30000, 150000);
}

/// Used vertices, centres of triangles, and points spread over the surface.
std::vector<glm::vec3> pointsToCover(const TriangleMesh& mesh, std::size_t count,
                                     std::uint64_t seed) {
  std::vector<glm::vec3> points = sampleSurface(mesh, densePointCount(count), seed + 1);
  std::vector<bool> used(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    points.emplace_back((a + b + c) / 3.0);
    for (const std::uint32_t vertex : {t.x, t.y, t.z}) used[vertex] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) points.push_back(mesh.positions[i]);
  return points;
}

class ProgressCounter {
 public:
  ProgressCounter(const std::function<void(double)>& report, std::size_t steps)
      : report_(report), steps_(steps) {}
  void step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (report_) report_(static_cast<double>(done_) / static_cast<double>(steps_));
  }

 private:
  const std::function<void(double)>& report_;
  std::size_t steps_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

SphereCover startingCover(const Variant& variant, const std::vector<glm::vec3>& surface,
                          const SolidGrid& solid) {
  std::vector<glm::vec3> points = surface;
  if (variant.withInterior) {
    const auto interior = solid.insidePoints(surface.size() / 2);
    points.insert(points.end(), interior.begin(), interior.end());
  }
  auto groups = clusterPoints(points, variant.count, variant.seed);
  groups.resize(surface.size());
  return SphereCover(surface, groups, variant.count, solid);
}

/// The radii once more against the points themselves, in the coordinates of the mesh, since
/// centres and radii have been rounded.
void growToCover(std::vector<Sphere>& spheres, std::span<const glm::vec3> points) {
  constexpr double roundingOfDistance = 1e-6;
  const auto distanceTo = [&](const Sphere& sphere, const glm::vec3& point) {
    return glm::distance(glm::dvec3(point), glm::dvec3(sphere.center));
  };
  std::vector<std::uint32_t> nearest(points.size());
  parallelFor(points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double smallest = std::numeric_limits<double>::max();
      for (std::uint32_t s = 0; s < spheres.size(); ++s) {
        const double excess = distanceTo(spheres[s], points[i]) - spheres[s].radius;
        if (excess >= smallest) continue;
        smallest = excess;
        nearest[i] = s;
        if (excess <= 0) break;
      }
    }
  });
  std::vector<double> radii;
  for (const Sphere& sphere : spheres) radii.push_back(sphere.radius);
  for (std::size_t i = 0; i < points.size(); ++i)
    radii[nearest[i]] = std::max(radii[nearest[i]], distanceTo(spheres[nearest[i]], points[i]));
  for (std::size_t s = 0; s < spheres.size(); ++s)
    spheres[s].radius = std::max(static_cast<float>(radii[s] * (1 + roundingOfDistance)),
                                 std::numeric_limits<float>::min());
}

void checkRequest(const TriangleMesh& mesh, std::size_t count) {
  if (count < 1 || count > maximumSphereCount)
    throw InputError("the number of spheres must be from 1 to " +
                     std::to_string(maximumSphereCount) + ", not " + std::to_string(count));
  if (mesh.triangles.empty() || !(surfaceArea(mesh) > 0))
    throw InputError("spheres cannot be fitted to a mesh without triangles; load one with some");
}

std::vector<Sphere> asSpheres(const std::vector<Ball>& balls, const UnitFrame& frame) {
  std::vector<Sphere> spheres;
  for (const Ball& ball : balls)
    spheres.push_back(
        {glm::vec3(frame.fromUnit(ball.center)), static_cast<float>(ball.radius / frame.scale())});
  return spheres;
}

/// Points in the unit frame: few for the search, all for the end.
struct UnitPoints {
  std::vector<glm::vec3> coarse, dense;
};

SphereCover fitVariant(const Variant& variant, const UnitPoints& points, const SolidGrid& solid,
                       ProgressCounter& progress) {
  SphereCover cover = startingCover(variant, points.coarse, solid);
  cover.refit();
  for (int round = 0; round < exchangeRounds(variant.count); ++round) {
    cover.splitUpTo(variant.count);
    cover.exchange();
    cover.refit();
  }
  cover.splitUpTo(variant.count);
  progress.step();
  cover.addPoints(points.dense);
  for (int i = 0; i < lastRefits; ++i) cover.refit();
  progress.step();
  return cover;
}

}  // namespace

SphereSet fitSpheres(const TriangleMesh& mesh, std::size_t count, const SphereFitOptions& options) {
  checkRequest(mesh, count);
  const UnitFrame frame(mesh);
  const TriangleMesh unitMesh = frame.toUnit(mesh);
  const SolidGrid solid(unitMesh, gridCells(count));
  const std::vector<glm::vec3> demanded = pointsToCover(mesh, count, options.seed);
  UnitPoints points;
  points.coarse = sampleSurface(unitMesh, coarsePointCount(count), options.seed);
  for (const glm::vec3& point : demanded) points.dense.push_back(frame.toUnit(point));

  const std::vector<Variant> variants = variantsFor(count, options.seed);
  std::vector<std::optional<SphereCover>> covers(variants.size());
  ProgressCounter progress(options.progress, 2 * variants.size());
  parallelFor(variants.size(), 1, [&](std::size_t i, std::size_t) {
    covers[i].emplace(fitVariant(variants[i], points, solid, progress));
  });
  std::size_t best = 0;
  for (std::size_t i = 1; i < covers.size(); ++i)
    if (covers[i]->cost() < covers[best]->cost()) best = i;

  SphereSet set;
  set.spheres = asSpheres(covers[best]->balls(), frame);
  growToCover(set.spheres, demanded);
  set.meshHash = meshHash(mesh);
  set.measures = measureSpheres(mesh, set.spheres);
  set.method = variants[best].name + ", exchange";
  set.seed = options.seed;
  return set;
}

}  // namespace haarlight
