#include "transfer/vertex_fan.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace haarlight {

namespace {

/// A corner of a triangle: unit edges to the next and the previous corner.
struct Corner {
  std::uint32_t triangle;
  int number;
  glm::dvec3 next, previous;

  glm::dvec3 normal() const { return glm::cross(next, previous); }
};

Corner cornerAt(const TriangleMesh& mesh, std::uint32_t triangle, const glm::vec3& position) {
  const glm::uvec3& t = mesh.triangles[triangle];
  int number = 0;
  while (number < 2 && mesh.positions[t[number]] != position) ++number;
  const glm::dvec3 apex = position;
  const auto edgeTo = [&](int corner) {
    return glm::normalize(glm::dvec3(mesh.positions[t[corner % 3]]) - apex);
  };
  return {triangle, number, edgeTo(number + 1), edgeTo(number + 2)};
}

/// A point just above the middle of a sector, on the side of the normal.
glm::dvec3 pointAbove(const Corner& corner, const glm::dvec3& normal) {
  constexpr double height = 0.05;
  const glm::dvec3 up = glm::normalize(corner.normal());
  return glm::normalize(corner.next + corner.previous) +
         (glm::dot(up, normal) < 0 ? -height : height) * up;
}

}  // namespace

VertexFan::VertexFan(const TriangleMesh& mesh, std::uint32_t vertex,
                     std::span<const std::uint32_t> faces) {
  constexpr double flat = 1e-6;  // faces that rise by less are level but for rounding
  const glm::dvec3 normal = mesh.normals[vertex];
  bool rises = false;
  double widest = 0;
  for (const std::uint32_t triangle : faces) {
    const Corner corner = cornerAt(mesh, triangle, mesh.positions[vertex]);
    const glm::dvec3 m = corner.normal();
    const double squared = glm::dot(m, m);
    if (!(squared > 0)) continue;
    const glm::uvec3& t = mesh.triangles[triangle];
    const bool facesNormal = glm::dot(m, glm::dvec3(mesh.normals[t[corner.number]])) > 0;
    sectors_.push_back({{triangle, corner.number, facesNormal},
                        m,
                        glm::cross(corner.previous, m) / squared,
                        glm::cross(m, corner.next) / squared});
    rises |= std::max(glm::dot(corner.next, normal), glm::dot(corner.previous, normal)) > flat;
    const double width = 1 - glm::dot(corner.next, corner.previous);
    if (t[corner.number] == vertex && width > widest) {
      widest = width;
      start_ = pointAbove(corner, normal);
    }
  }
  if (!rises || widest == 0) sectors_.clear();
}

std::optional<VertexFan::Face> VertexFan::blockingFace(const glm::dvec3& direction) const {
  std::optional<Face> nearest;
  double distance = std::numeric_limits<double>::max();
  bool through = false;
  for (const Sector& sector : sectors_) {
    const double height = glm::dot(start_, sector.normal);
    const double along = -height / glm::dot(direction, sector.normal);
    if (!(along > 0) || std::isinf(along)) continue;
    const glm::dvec3 point = start_ + along * direction;
    if (!(glm::dot(point, sector.first) >= 0 && glm::dot(point, sector.second) >= 0)) continue;
    through = !through;
    if (along < distance) {
      distance = along;
      nearest = sector.face;
      nearest->lit = sector.face.lit == (height > 0);
    }
  }
  return through ? nearest : std::nullopt;
}

}  // namespace haarlight
