#include "mesh/flatness.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/mesh_measures.h"

namespace haarlight {

namespace {

struct Farthest {
  glm::dvec3 point;
  double measure;
};

/// The vertex with the largest value of a measure.
template <typename Measure>
Farthest farthestVertex(const TriangleMesh& mesh, const Measure& measure) {
  Farthest farthest{mesh.positions[mesh.triangles[0].x], 0};
  for (const glm::uvec3& t : mesh.triangles)
    for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
      const glm::dvec3 point = mesh.positions[vertex];
      const double value = measure(point);
      if (value > farthest.measure) farthest = {point, value};
    }
  return farthest;
}

/// How far apart rounding may move vertices of a plane: a millionth of the extent, and some units
/// in the last place of the largest coordinate.
double tolerance(const TriangleMesh& mesh) {
  const BoundingBox box = boundingBox(mesh);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest =
        std::max({largest, std::abs(double(box.lower[axis])), std::abs(double(box.upper[axis]))});
  return 1e-6 * glm::distance(glm::dvec3(box.lower), glm::dvec3(box.upper)) + 0x1p-21 * largest;
}

}  // namespace

bool liesInPlane(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return true;
  const double allowed = tolerance(mesh);
  // A long side, the vertex farthest from it, and the vertex farthest from the plane of the three.
  const glm::dvec3 any = mesh.positions[mesh.triangles[0].x];
  const glm::dvec3 first =
      farthestVertex(mesh, [&](const glm::dvec3& p) { return glm::distance(p, any); }).point;
  const Farthest second =
      farthestVertex(mesh, [&](const glm::dvec3& p) { return glm::distance(p, first); });
  if (second.measure <= allowed) return true;
  const glm::dvec3 along = (second.point - first) / second.measure;
  const Farthest third = farthestVertex(
      mesh, [&](const glm::dvec3& p) { return glm::length(glm::cross(p - first, along)); });
  if (third.measure <= allowed) return true;
  const glm::dvec3 normal = glm::cross(along, third.point - first) / third.measure;
  const Farthest off = farthestVertex(
      mesh, [&](const glm::dvec3& p) { return std::abs(glm::dot(p - first, normal)); });
  return off.measure <= allowed;
}

}  // namespace haarlight
