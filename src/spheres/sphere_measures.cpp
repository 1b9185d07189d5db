#include "spheres/sphere_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "mesh/inside_test.h"
#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/topology.h"
#include "spheres/unit_frame.h"

namespace haarlight {

namespace {

constexpr std::size_t grain = 1024;

/// Part of the points point(random) for which predicate(point) holds; the same points for any
/// number of threads.
template <typename Point, typename Predicate>
double sampledFraction(std::size_t samples, std::uint64_t seed, const Point& point,
                       const Predicate& predicate) {
  std::vector<std::size_t> counts((samples + grain - 1) / grain);
  parallelFor(samples, grain, [&](std::size_t begin, std::size_t end) {
    Random random(seed ^ (begin / grain + 1) * 0x9e3779b97f4a7c15);
    for (std::size_t i = begin; i < end; ++i) counts[begin / grain] += predicate(point(random, i));
  });
  const auto hits = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  return static_cast<double>(hits) / static_cast<double>(samples);
}

glm::dvec3 pointInBall(Random& random) {
  const double z = 2 * random.uniform() - 1, angle = 2 * std::numbers::pi * random.uniform();
  const double flat = std::sqrt(1 - z * z);
  return std::cbrt(random.uniform()) *
         glm::dvec3(flat * std::cos(angle), flat * std::sin(angle), z);
}

double enclosedVolume(const TriangleMesh& mesh, const InsideTest& inside, std::size_t samples,
                      std::uint64_t seed) {
  const MeshTopology topology = measureTopology(mesh);
  if (topology.closed && topology.misorientedEdges == 0 && topology.components == 1)
    return std::abs(signedVolume(mesh));
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 lower = box.lower, extent = glm::dvec3(box.upper) - lower;
  const auto point = [&](Random& random, std::size_t) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return glm::vec3(lower + extent * glm::dvec3(x, y, z));
  };
  const double fraction =
      sampledFraction(samples, seed, point, [&](const glm::vec3& p) { return inside.contains(p); });
  return fraction * extent.x * extent.y * extent.z;
}

}  // namespace

double coveredFraction(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                       std::size_t samples, std::uint64_t seed) {
  const std::vector<glm::vec3> points = sampleSurface(mesh, samples, seed);
  if (points.empty()) return 0;
  const auto isCovered = [&](const glm::vec3& point) {
    return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
      return glm::distance(point, sphere.center) <= sphere.radius;
    });
  };
  return sampledFraction(
      points.size(), seed, [&](Random&, std::size_t i) { return points[i]; }, isCovered);
}

std::optional<double> outsideVolumeRatio(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                                         std::size_t samples, std::uint64_t seed) {
  if (mesh.triangles.empty() || samples == 0) return std::nullopt;
  const UnitFrame frame(mesh);
  const TriangleMesh unitMesh = frame.toUnit(mesh);
  const InsideTest inside(unitMesh);
  const double meshVolume = enclosedVolume(unitMesh, inside, samples, seed);
  if (!(meshVolume > 0)) return std::nullopt;

  std::vector<double> volumeUpTo;
  double volume = 0;
  for (const Sphere& sphere : spheres)
    volumeUpTo.push_back(volume +=
                         4.0 / 3.0 * std::numbers::pi * std::pow(sphere.radius * frame.scale(), 3));
  // Sample i belongs to the sphere at the i-th of equal parts of the summed volume.
  const auto point = [&](Random& random, std::size_t i) {
    const double at = (double(i) + 0.5) / double(samples) * volume;
    const auto found = std::upper_bound(volumeUpTo.begin(), volumeUpTo.end() - 1, at);
    const Sphere& sphere = spheres[std::size_t(found - volumeUpTo.begin())];
    const glm::dvec3 offset = pointInBall(random) * (sphere.radius * frame.scale());
    return glm::vec3(glm::dvec3(frame.toUnit(sphere.center)) + offset);
  };
  if (spheres.empty()) return 0;
  return volume / meshVolume * sampledFraction(samples, seed, point, [&](const glm::vec3& p) {
           return !inside.contains(p);
         });
}

SphereMeasures measureSpheres(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                              std::size_t samples, std::uint64_t seed) {
  return {coveredFraction(mesh, spheres, samples, seed),
          outsideVolumeRatio(mesh, spheres, samples, seed)};
}

}  // namespace haarlight
