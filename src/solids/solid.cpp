#include "solids/solid.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "solids/shape_geometry.h"
#include "solids/solid_checks.h"

namespace haarlight {

Solid::Solid(const Shape& shape, const Placement& placement)
    : shape_(shape), placement_(placement) {
  checkShape(shape);
}

bool Solid::isConvex() const {
  return !std::holds_alternative<TorusShape>(shape_);
}

AxisBox Solid::bounds() const {
  AxisBox box;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0);
    direction[axis] = 1;
    box.lower[axis] = support(-direction)[axis];
    box.upper[axis] = support(direction)[axis];
  }
  return box;
}

bool Solid::contains(const glm::dvec3& point) const {
  const glm::dvec3 own = placement_.toOwnPoint(point);
  return std::visit([&](const auto& shape) { return containsPoint(surfaceOf(shape), own); },
                    shape_);
}

glm::dvec3 Solid::support(const glm::dvec3& direction) const {
  const glm::dvec3 own = placement_.toOwnDirection(direction);
  return placement_.toWorldPoint(
      std::visit([&](const auto& shape) { return furthestPoint(surfaceOf(shape), own); }, shape_));
}

std::optional<SolidHit> Solid::intersect(const Ray& ray) const {
  const glm::dvec3 origin = placement_.toOwnPoint(ray.origin);
  const glm::dvec3 direction = placement_.toOwnDirection(ray.direction);
  const double speed = glm::length(direction);
  if (!(speed > 0 && std::isfinite(speed))) return std::nullopt;
  const glm::dvec3 unit = direction / speed;
  const double start = glm::dot(origin, unit);
  const CenteredLine line{origin - start * unit, unit};
  const auto found =
      std::visit([&](const auto& shape) { return crossings(surfaceOf(shape), line); }, shape_);
  for (const SurfaceCrossing& crossing : found) {
    const double t = (crossing.at - start) / speed;
    if (t >= ray.near && t <= ray.far)
      return SolidHit{t, placement_.toWorldDirection(crossing.normal)};
  }
  return std::nullopt;
}

bool Solid::blocks(const Ray& ray) const {
  if (!(ray.near <= ray.far)) return false;
  // An end on the surface counts, which its crossing may miss by rounding.
  return contains(ray.at(ray.near)) || intersect(ray) ||
         (std::isfinite(ray.far) && contains(ray.at(ray.far)));
}

}  // namespace haarlight
