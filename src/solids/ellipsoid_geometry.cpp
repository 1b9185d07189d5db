#include <cmath>
#include <glm/geometric.hpp>

#include "solids/shape_geometry.h"

namespace haarlight {

bool containsPoint(const EllipsoidShape& shape, const glm::dvec3& point) {
  return glm::length(point / shape.radii) <= 1 + onSurface;
}

glm::dvec3 furthestPoint(const EllipsoidShape& shape, const glm::dvec3& direction) {
  return shape.radii * glm::normalize(shape.radii * glm::normalize(direction));
}

SurfaceCrossings crossings(const EllipsoidShape& shape, const CenteredLine& line) {
  // Where the ellipsoid is the unit sphere: half the chord from the line's point next to the
  // centre.
  const glm::dvec3 point = line.point / shape.radii, direction = line.direction / shape.radii;
  const double squaredSpeed = glm::dot(direction, direction);
  const double middle = -glm::dot(point, direction) / squaredSpeed;
  const glm::dvec3 nearest = point + middle * direction;
  const double room = 1 - glm::dot(nearest, nearest);
  SurfaceCrossings result;
  if (!(room >= 0)) return result;
  const double half = std::sqrt(room / squaredSpeed);
  for (const double s : {middle - half, middle + half}) {
    const glm::dvec3 onUnitSphere = glm::normalize(nearest + (s - middle) * direction);
    result.add({s, glm::normalize(onUnitSphere / shape.radii)});
  }
  return result;
}

}  // namespace haarlight
