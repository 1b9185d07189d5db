#include "spheres/sphere_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "mesh/inside_test.h"
#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/topology.h"
#include "spheres/silhouette_error.h"
#include "spheres/unit_frame.h"

namespace haarlight {

namespace {

constexpr std::size_t grain = 1024;

/// Mean of weight(point(random, i)); the same points for any number of threads.
template <typename Point, typename Weight>
glm::dvec2 sampledMean(std::size_t samples, std::uint64_t seed, const Point& point,
                       const Weight& weight) {
  std::vector<glm::dvec2> sums((samples + grain - 1) / grain, glm::dvec2(0));
  parallelFor(samples, grain, [&](std::size_t begin, std::size_t end) {
    // Hashed twice, since the streams of seeds that differ by little may overlap.
    Random random(Random(Random(seed).next() + begin / grain).next());
    for (std::size_t i = begin; i < end; ++i) sums[begin / grain] += weight(point(random, i));
  });
  return std::accumulate(sums.begin(), sums.end(), glm::dvec2(0)) / double(samples);
}

glm::dvec3 pointInBall(Random& random) {
  const double z = 2 * random.uniform() - 1, angle = 2 * std::numbers::pi * random.uniform();
  const double flat = std::sqrt(1 - z * z);
  return std::cbrt(random.uniform()) *
         glm::dvec3(flat * std::cos(angle), flat * std::sin(angle), z);
}

glm::vec3 pointInBox(Random& random, const BoundingBox& box) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  const glm::dvec3 lower = box.lower, upper = box.upper;
  return glm::vec3(lower + (upper - lower) * glm::dvec3(x, y, z));
}

bool contains(const Sphere& sphere, const glm::vec3& point) {
  return glm::distance(point, sphere.center) <= sphere.radius;
}

/// The volumes of one mesh and one set, both in the unit frame.
class VolumeSampler {
 public:
  VolumeSampler(const TriangleMesh& mesh, std::vector<Sphere> spheres)
      : mesh_(mesh), box_(boundingBox(mesh)), inside_(mesh), spheres_(std::move(spheres)) {
    for (const Sphere& sphere : spheres_)
      volumeUpTo_.push_back(4.0 / 3.0 * std::numbers::pi * std::pow(double(sphere.radius), 3) +
                            (volumeUpTo_.empty() ? 0 : volumeUpTo_.back()));
  }

  /// Of the mesh, and its part in no sphere.
  glm::dvec2 meshAndUncovered(std::size_t samples, std::uint64_t seed) const {
    const auto weight = [&](const glm::vec3& point) {
      if (!inside_.contains(point)) return glm::dvec2(0);
      return glm::dvec2(1, !std::ranges::any_of(spheres_, [&](const Sphere& sphere) {
                          return contains(sphere, point);
                        }));
    };
    const auto point = [&](Random& random, std::size_t) { return pointInBox(random, box_); };
    const glm::dvec3 extent = glm::dvec3(box_.upper) - glm::dvec3(box_.lower);
    glm::dvec2 volumes =
        sampledMean(samples, seed, point, weight) * (extent.x * extent.y * extent.z);
    const MeshTopology topology = measureTopology(mesh_);
    if (topology.closed && topology.misorientedEdges == 0 && topology.components == 1)
      volumes.x = std::abs(signedVolume(mesh_));
    return volumes;
  }

  /// Outside the mesh: summed over the spheres, and of their union, in which a point that lies in
  /// k spheres counts 1/k for each.
  glm::dvec2 outside(std::size_t samples, std::uint64_t seed) const {
    if (spheres_.empty()) return glm::dvec2(0);
    const auto weight = [&](const glm::vec3& point) {
      if (inside_.contains(point)) return glm::dvec2(0);
      const auto around = std::ranges::count_if(
          spheres_, [&](const Sphere& sphere) { return contains(sphere, point); });
      return glm::dvec2(1, 1 / double(std::max<std::ptrdiff_t>(around, 1)));
    };
    const auto point = [&](Random& random, std::size_t i) {
      return pointInSpheres(random, (double(i) + 0.5) / double(samples));
    };
    return sampledMean(samples, seed, point, weight) * volumeUpTo_.back();
  }

 private:
  /// In the sphere at a part of the summed volume.
  glm::vec3 pointInSpheres(Random& random, double part) const {
    const auto found =
        std::upper_bound(volumeUpTo_.begin(), volumeUpTo_.end() - 1, part * volumeUpTo_.back());
    const Sphere& sphere = spheres_[std::size_t(found - volumeUpTo_.begin())];
    return glm::vec3(glm::dvec3(sphere.center) + pointInBall(random) * double(sphere.radius));
  }

  const TriangleMesh& mesh_;
  BoundingBox box_;
  InsideTest inside_;
  std::vector<Sphere> spheres_;
  std::vector<double> volumeUpTo_;  ///< of each sphere and those before it
};

}  // namespace

double coveredFraction(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                       std::size_t samples, std::uint64_t seed) {
  const std::vector<glm::vec3> points = sampleSurface(mesh, samples, seed);
  if (points.empty()) return 0;
  const auto isCovered = [&](const glm::vec3& point) {
    return glm::dvec2(std::ranges::any_of(
        spheres, [&](const Sphere& sphere) { return contains(sphere, point); }));
  };
  return sampledMean(
             points.size(), seed, [&](Random&, std::size_t i) { return points[i]; }, isCovered)
      .x;
}

std::optional<VolumeMeasures> volumeMeasures(const TriangleMesh& mesh,
                                             std::span<const Sphere> spheres, std::size_t samples,
                                             std::uint64_t seed) {
  if (mesh.triangles.empty() || samples == 0) return std::nullopt;
  const UnitFrame frame(mesh);
  const TriangleMesh unitMesh = frame.toUnit(mesh);
  const VolumeSampler sampler(unitMesh, frame.toUnit(spheres));
  const glm::dvec2 meshAndUncovered = sampler.meshAndUncovered(samples, seed);
  if (!(meshAndUncovered.x > 0)) return std::nullopt;
  const glm::dvec2 outside = sampler.outside(samples, seed) / meshAndUncovered.x;
  return VolumeMeasures{outside.x, outside.y, meshAndUncovered.y / meshAndUncovered.x};
}

SphereMeasures measureSpheres(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                              std::size_t samples, std::uint64_t seed) {
  SphereMeasures measures;
  measures.coveredFraction = coveredFraction(mesh, spheres, samples, seed);
  if (const auto volumes = volumeMeasures(mesh, spheres, samples, seed)) {
    measures.outsideVolumeRatio = volumes->summedOutside;
    measures.unionOutsideRatio = volumes->unionOutside;
    measures.uncoveredVolumeRatio = volumes->uncovered;
  }
  measures.silhouette = silhouetteError(mesh, spheres, {.seed = seed});
  return measures;
}

std::vector<Sphere> grownToCover(std::span<const Sphere> spheres,
                                 std::span<const glm::vec3> points) {
  constexpr double roundingOfDistance = 1e-6;
  std::vector<Sphere> grown(spheres.begin(), spheres.end());
  const auto distanceTo = [&](const Sphere& sphere, const glm::vec3& point) {
    return glm::distance(glm::dvec3(point), glm::dvec3(sphere.center));
  };
  const std::size_t covered = spheres.size();
  std::vector<std::size_t> cheapest(points.size());
  parallelFor(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double smallest = std::numeric_limits<double>::max();
      for (std::size_t s = 0; s < spheres.size() && cheapest[i] != covered; ++s) {
        const double radius = spheres[s].radius, distance = distanceTo(spheres[s], points[i]);
        const double growth = distance * distance * distance - radius * radius * radius;
        if (growth >= smallest) continue;
        smallest = growth;
        cheapest[i] = contains(spheres[s], points[i]) ? covered : s;
      }
    }
  });
  std::vector<double> radii;
  for (const Sphere& sphere : spheres) radii.push_back(sphere.radius);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const std::size_t s = cheapest[i]; s != covered)
      radii[s] = std::max(radii[s], distanceTo(spheres[s], points[i]) * (1 + roundingOfDistance));
  for (std::size_t s = 0; s < grown.size(); ++s)
    grown[s].radius = std::max(static_cast<float>(radii[s]), grown[s].radius);
  return grown;
}

std::vector<glm::vec3> sampleInterior(const TriangleMesh& mesh, std::size_t count,
                                      std::uint64_t seed) {
  if (mesh.triangles.empty()) return {};
  const UnitFrame frame(mesh);
  const TriangleMesh unitMesh = frame.toUnit(mesh);
  const InsideTest inside(unitMesh);
  const BoundingBox box = boundingBox(unitMesh);
  std::vector<glm::vec3> points;
  Random random(seed);
  constexpr std::size_t round = 65536, mostMisses = 16;
  for (std::size_t misses = 0; points.size() < count && misses < mostMisses;) {
    std::vector<glm::vec3> candidates(round);
    for (glm::vec3& point : candidates) point = pointInBox(random, box);
    std::vector<std::uint8_t> isInside(round);
    parallelFor(round, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) isInside[i] = inside.contains(candidates[i]);
    });
    const std::size_t before = points.size();
    for (std::size_t i = 0; i < round && points.size() < count; ++i)
      if (isInside[i]) points.emplace_back(frame.fromUnit(candidates[i]));
    misses = points.size() == before ? misses + 1 : 0;
  }
  return points;
}

}  // namespace haarlight
