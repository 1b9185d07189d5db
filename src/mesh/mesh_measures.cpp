#include "mesh/mesh_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "base/file.h"
#include "mesh/random.h"

namespace haarlight {

namespace {

double areaOf(const TriangleMesh& mesh, const glm::uvec3& t) {
  return triangleArea(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
}

glm::vec3 triangleNormal(const TriangleMesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
  return glm::vec3(glm::normalize(glm::cross(b - a, c - a)));
}

glm::vec3 pointInTriangle(const TriangleMesh& mesh, const glm::uvec3& t, double u, double v) {
  const double root = std::sqrt(u);
  return glm::vec3((1 - root) * glm::dvec3(mesh.positions[t.x]) +
                   root * (1 - v) * glm::dvec3(mesh.positions[t.y]) +
                   root * v * glm::dvec3(mesh.positions[t.z]));
}

template <typename Item>
std::uint64_t checksumOf(const std::vector<Item>& items) {
  return checksum(
      std::span(reinterpret_cast<const std::uint8_t*>(items.data()), items.size() * sizeof(Item)));
}

}  // namespace

BoundingBox boundingBox(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  BoundingBox box{glm::vec3(std::numeric_limits<float>::max()),
                  glm::vec3(std::numeric_limits<float>::lowest())};
  for (const glm::uvec3& t : mesh.triangles)
    for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
      box.lower = glm::min(box.lower, mesh.positions[vertex]);
      box.upper = glm::max(box.upper, mesh.positions[vertex]);
    }
  return box;
}

double signedVolume(const TriangleMesh& mesh) {
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) / 2.0;
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = glm::dvec3(mesh.positions[t.x]) - center;
    const glm::dvec3 b = glm::dvec3(mesh.positions[t.y]) - center;
    const glm::dvec3 c = glm::dvec3(mesh.positions[t.z]) - center;
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6;
}

double surfaceArea(const TriangleMesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) sum += areaOf(mesh, t);
  return sum;
}

std::vector<SurfacePoint> sampleSurfaceWithNormals(const TriangleMesh& mesh, std::size_t count,
                                                   std::uint64_t seed) {
  std::vector<double> areaUpTo;
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) areaUpTo.push_back(area += areaOf(mesh, t));
  if (!(area > 0)) return {};
  Random random(seed);
  std::vector<SurfacePoint> samples;
  samples.reserve(count);
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    while (triangle + 1 < areaUpTo.size() && areaUpTo[triangle] <= at * area) ++triangle;
    const double u = random.uniform(), v = random.uniform();
    const glm::uvec3& t = mesh.triangles[triangle];
    samples.push_back({pointInTriangle(mesh, t, u, v), triangleNormal(mesh, t)});
  }
  return samples;
}

std::vector<glm::vec3> sampleSurface(const TriangleMesh& mesh, std::size_t count,
                                     std::uint64_t seed) {
  std::vector<glm::vec3> positions;
  positions.reserve(count);
  for (const SurfacePoint& sample : sampleSurfaceWithNormals(mesh, count, seed))
    positions.push_back(sample.position);
  return positions;
}

std::uint64_t meshHash(const TriangleMesh& mesh) {
  const std::vector<std::uint64_t> parts = {mesh.positions.size(), checksumOf(mesh.positions),
                                            mesh.triangles.size(), checksumOf(mesh.triangles)};
  return checksumOf(parts);
}

}  // namespace haarlight
