#include "spheres/surface_receivers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/mesh_measures.h"
#include "visibility/sphere_bin.h"

namespace haarlight {

namespace {

std::vector<glm::vec3> positionsOf(const std::vector<SurfacePoint>& samples) {
  std::vector<glm::vec3> positions;
  for (const SurfacePoint& sample : samples) positions.push_back(sample.position);
  return positions;
}

/// Of the hemisphere around a normal, the part within an angular radius of 90° and less of a
/// direction whose cosine with the normal is given.
double blockedPart(double cosine) {
  if (cosine >= 0) return (1 + cosine) / 2;
  return std::max(0.0, 1 - double(horizonFactor) * cosine * cosine) / 2;
}

}  // namespace

SurfaceReceivers::SurfaceReceivers(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed)
    : points_({}) {
  const auto samples = sampleSurfaceWithNormals(mesh, count, seed);
  points_ = PointBlocks(positionsOf(samples));
  for (const std::uint32_t place : points_.originalPlaces())
    normals_.push_back(samples[place].normal);
}

double SurfaceReceivers::blockedBy(const Ball& ball) const {
  double blocked = 0;
  points_.forEachIn(ball, [&](std::uint32_t i) {
    const glm::dvec3 to = ball.center - glm::dvec3(points_.points()[i]);
    const double distance = glm::length(to);
    if (distance > 0) blocked += blockedPart(glm::dot(to, glm::dvec3(normals_[i])) / distance);
  });
  return normals_.empty() ? 0 : blocked / double(normals_.size());
}

}  // namespace haarlight
