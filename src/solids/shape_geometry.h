#pragma once

/// The formulas of the four kinds of surface, in a shape's own coordinates (inside of Solid). A
/// sphere is an ellipsoid, and a cylinder a frustum whose radii are equal.

#include <cmath>
#include <glm/vec3.hpp>

#include "solids/line_crossings.h"
#include "solids/shapes.h"

namespace haarlight {

/// What counts as on a surface, as a part of the measures: well above the rounding of points that
/// are computed to lie on it.
inline constexpr double onSurface = 1e-12;

inline double distanceFromAxis(const glm::dvec3& point) {
  return std::sqrt(point.x * point.x + point.z * point.z);
}

inline EllipsoidShape surfaceOf(const SphereShape& sphere) {
  return {glm::dvec3(sphere.radius)};
}
inline ConeShape surfaceOf(const CylinderShape& cylinder) {
  return {cylinder.radius, cylinder.height, cylinder.radius};
}
inline const EllipsoidShape& surfaceOf(const EllipsoidShape& shape) {
  return shape;
}
inline const BoxShape& surfaceOf(const BoxShape& shape) {
  return shape;
}
inline const ConeShape& surfaceOf(const ConeShape& shape) {
  return shape;
}
inline const TorusShape& surfaceOf(const TorusShape& shape) {
  return shape;
}

bool containsPoint(const EllipsoidShape& shape, const glm::dvec3& point);
bool containsPoint(const BoxShape& shape, const glm::dvec3& point);
bool containsPoint(const ConeShape& shape, const glm::dvec3& point);
bool containsPoint(const TorusShape& shape, const glm::dvec3& point);

glm::dvec3 furthestPoint(const EllipsoidShape& shape, const glm::dvec3& direction);
glm::dvec3 furthestPoint(const BoxShape& shape, const glm::dvec3& direction);
glm::dvec3 furthestPoint(const ConeShape& shape, const glm::dvec3& direction);
glm::dvec3 furthestPoint(const TorusShape& shape, const glm::dvec3& direction);

/// The way to a point from the nearest point of the circle inside a torus's tube.
glm::dvec3 fromCircle(const TorusShape& shape, const glm::dvec3& point);

SurfaceCrossings crossings(const EllipsoidShape& shape, const CenteredLine& line);
SurfaceCrossings crossings(const BoxShape& shape, const CenteredLine& line);
SurfaceCrossings crossings(const ConeShape& shape, const CenteredLine& line);
SurfaceCrossings crossings(const TorusShape& shape, const CenteredLine& line);

}  // namespace haarlight
