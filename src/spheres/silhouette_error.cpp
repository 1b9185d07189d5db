#include "spheres/silhouette_error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/ray_scene.h"
#include "spheres/unit_frame.h"

namespace haarlight {

namespace {

constexpr std::size_t packet = 16;

/// Numbers of rays that meet something.
struct Hits {
  std::size_t mesh = 0, onlyMesh = 0, onlySpheres = 0;
};

/// Mesh and spheres in the unit frame, ready for rays.
class Outlines {
 public:
  Outlines(const TriangleMesh& mesh, std::vector<Sphere> spheres)
      : mesh_(mesh),
        spheres_(std::move(spheres)),
        box_(boundingBox(mesh)),
        meshScene_(mesh),
        sphereScene_(spheres_) {}

  Hits compare(const glm::dvec3& eye, std::size_t rays, double turn) const {
    const glm::dvec3 center = (glm::dvec3(box_.lower) + glm::dvec3(box_.upper)) / 2.0;
    const glm::dvec3 axis = glm::normalize(center - eye);
    const double cosine = smallestCosine(eye, axis);
    const auto directions = directionsInCap(axis, cosine, rays, turn);
    Hits hits;
    for (std::size_t i = 0; i < rays; i += packet) add(eye, directions, i, hits);
    return hits;
  }

  const BoundingBox& meshBox() const { return box_; }

 private:
  /// Of the cone around `axis` in which mesh and spheres lie; -1 from within a sphere.
  double smallestCosine(const glm::dvec3& eye, const glm::dvec3& axis) const {
    double smallest = 1;
    for (const glm::uvec3& t : mesh_.triangles)
      for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
        const glm::dvec3 to = glm::dvec3(mesh_.positions[vertex]) - eye;
        smallest = std::min(smallest, glm::dot(to, axis) / glm::length(to));
      }
    for (const Sphere& sphere : spheres_) {
      const glm::dvec3 to = glm::dvec3(sphere.center) - eye;
      const double distance = glm::length(to);
      if (distance <= sphere.radius) return -1;
      const double angle = std::acos(std::clamp(glm::dot(to / distance, axis), -1.0, 1.0)) +
                           std::asin(sphere.radius / distance);
      smallest = std::min(smallest, std::cos(std::min(angle, std::numbers::pi)));
    }
    return smallest;
  }

  void add(const glm::dvec3& eye, const std::vector<glm::dvec3>& directions, std::size_t begin,
           Hits& hits) const {
    std::array<glm::vec3, packet> origins, rays{};
    origins.fill(glm::vec3(eye));
    const std::size_t count = std::min(packet, directions.size() - begin);
    for (std::size_t i = 0; i < count; ++i) rays[i] = glm::vec3(directions[begin + i]);
    const auto valid = static_cast<std::uint16_t>((1u << count) - 1);
    const unsigned mesh = meshScene_.occluded16(origins, rays, valid);
    const unsigned spheres = sphereScene_.occluded16(origins, rays, valid);
    hits.mesh += std::size_t(std::popcount(mesh));
    hits.onlyMesh += std::size_t(std::popcount(mesh & ~spheres));
    hits.onlySpheres += std::size_t(std::popcount(spheres & ~mesh));
  }

  const TriangleMesh& mesh_;
  std::vector<Sphere> spheres_;
  BoundingBox box_;
  RayScene meshScene_, sphereScene_;
};

}  // namespace

SilhouetteError silhouetteError(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                                const SilhouetteSampling& sampling) {
  if (mesh.triangles.empty()) return {};
  const UnitFrame frame(mesh);
  const TriangleMesh unitMesh = frame.toUnit(mesh);
  const Outlines outlines(unitMesh, frame.toUnit(spheres));
  const auto eyes =
      viewpointsAround(outlines.meshBox(), sampling.viewpoints, sampling.seed, sampling.range);
  std::vector<Hits> hits(eyes.size());
  parallelFor(eyes.size(), 1, [&](std::size_t i, std::size_t) {
    hits[i] = outlines.compare(eyes[i], sampling.raysPerViewpoint,
                               Random(sampling.seed + 1 + i).uniform());
  });
  SilhouetteError error;
  std::size_t seen = 0;
  for (const Hits& one : hits) {
    if (one.mesh == 0) continue;
    const double over = double(one.onlySpheres) / double(one.mesh);
    const double under = double(one.onlyMesh) / double(one.mesh);
    error.over += over;
    error.under += under;
    error.worst = std::max(error.worst, over + under);
    ++seen;
  }
  if (seen == 0) return {};
  error.over /= double(seen);
  error.under /= double(seen);
  error.mean = error.over + error.under;
  return error;
}

}  // namespace haarlight
