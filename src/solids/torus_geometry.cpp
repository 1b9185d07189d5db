#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "solids/root_between.h"
#include "solids/shape_geometry.h"

namespace haarlight {

namespace {

/// The unit vector from the axis to a point; one of them for a point of the axis.
glm::dvec3 awayFromAxis(const glm::dvec3& point) {
  const double distance = distanceFromAxis(point);
  if (distance == 0) return {1, 0, 0};
  return {point.x / distance, 0, point.z / distance};
}

/// The distance from the surface along a line; negative inside.
ValueAndSlope signedDistance(const TorusShape& shape, const CenteredLine& line, double s) {
  const glm::dvec3 away = fromCircle(shape, line.at(s));
  const double distance = glm::length(away);
  return {distance - shape.minorRadius, glm::dot(away, line.direction) / distance};
}

/// A few ascending numbers.
struct Places {
  std::array<double, 5> at;
  int count = 0;
  void add(double s) { at[count++] = s; }
};

/// Calls found(a, b) for each two neighbours between which the function's sign changes.
template <typename Function, typename Found>
void signChanges(const Function& function, const Places& places, const Found& found) {
  for (int i = 0; i + 1 < places.count; ++i)
    if ((function(places.at[i]).value > 0) != (function(places.at[i + 1]).value > 0))
      found(places.at[i], places.at[i + 1]);
}

/// Where the quartic (|p|² + R² − r²)² − 4 R² (x² + z²) of the line's points p turns, from −reach
/// to reach, with both. As the line's point is the one next to the origin, |p|² = s² + |point|², so
/// that neither the quartic s⁴ + 2 α s² + 4 β s + … has a cubic term nor its derivative
/// 4 (s³ + α s + β) a quadratic one.
Places turningPoints(const TorusShape& shape, const CenteredLine& line, double reach) {
  const double squaredMajor = shape.majorRadius * shape.majorRadius;
  const glm::dvec3 p = line.point, d = line.direction;
  const double alpha = glm::dot(p, p) + squaredMajor - shape.minorRadius * shape.minorRadius -
                       2 * squaredMajor * (1 - d.y * d.y);
  const double beta = 2 * squaredMajor * p.y * d.y;
  const auto derivative = [=](double s) {
    return ValueAndSlope{(s * s + alpha) * s + beta, 3 * s * s + alpha};
  };
  Places monotone, result;
  monotone.add(-reach);
  const double extremum = std::sqrt(std::max(0.0, -alpha / 3));
  if (extremum > 0 && extremum < reach) monotone.add(-extremum), monotone.add(extremum);
  monotone.add(reach);
  result.add(-reach);
  signChanges(derivative, monotone,
              [&](double low, double high) { result.add(rootBetween(derivative, low, high)); });
  result.add(reach);
  return result;
}

}  // namespace

glm::dvec3 fromCircle(const TorusShape& shape, const glm::dvec3& point) {
  const glm::dvec3 outwards = awayFromAxis(point);
  return (distanceFromAxis(point) - shape.majorRadius) * outwards + glm::dvec3(0, point.y, 0);
}

bool containsPoint(const TorusShape& shape, const glm::dvec3& point) {
  return glm::length(fromCircle(shape, point)) <= shape.minorRadius + onSurface * shape.majorRadius;
}

glm::dvec3 furthestPoint(const TorusShape& shape, const glm::dvec3& direction) {
  return shape.majorRadius * awayFromAxis(direction) +
         shape.minorRadius * glm::normalize(direction);
}

SurfaceCrossings crossings(const TorusShape& shape, const CenteredLine& line) {
  const double reach = 1.01 * (shape.majorRadius + shape.minorRadius);
  SurfaceCrossings result;
  if (!(glm::length(line.point) < reach)) return result;
  const auto distance = [&](double s) { return signedDistance(shape, line, s); };
  // The quartic has the sign of the distance, which keeps more digits of it.
  signChanges(distance, turningPoints(shape, line, reach), [&](double low, double high) {
    const double s = rootBetween(distance, low, high);
    result.add({s, glm::normalize(fromCircle(shape, line.at(s)))});
  });
  return result;
}

}  // namespace haarlight
