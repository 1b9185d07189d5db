#include "shadow/torus_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "solids/shape_geometry.h"

namespace haarlight {

TorusShadow::TorusShadow(const Solid& solid)
    : solid_(solid), shape_(std::get<TorusShape>(solid.shape())) {}

double TorusShadow::distance(const glm::dvec3& point) const {
  return glm::length(fromCircle(shape_, solid_.placement().toOwnPoint(point))) - shape_.minorRadius;
}

glm::dvec3 TorusShadow::nearestSurfacePoint(const glm::dvec3& point) const {
  const glm::dvec3 own = solid_.placement().toOwnPoint(point), away = fromCircle(shape_, own);
  const double length = glm::length(away);
  const glm::dvec3 outwards = length > 0 ? away / length : glm::dvec3(0, 1, 0);
  return solid_.placement().toWorldPoint(own - away + shape_.minorRadius * outwards);
}

CellShadow TorusShadow::on(const Shaft& shaft, bool own) const {
  if (passesBy(shaft, own)) return CellShadow::none;
  const double radius = shaft.radiusAt(0) + shaft.margin();
  if (own && leastSlope(shaft.center(), radius, shaft, -1) > 0) return CellShadow::all;
  return liesWithin(shaft) ? CellShadow::all : CellShadow::unknown;
}

/// Looks where the middle of the shaft lies in the torus.
bool TorusShadow::liesWithin(const Shaft& shaft) const {
  if (shaft.length() == 0) return distance(shaft.center()) + shaft.radiusAt(0) < -shaft.margin();
  Ray ray{shaft.center(), shaft.towards(), 0, shaft.length()};
  std::vector<double> places{0};
  while (const auto hit = solid_.intersect(ray)) {
    places.push_back(hit->t);
    ray.near = std::nextafter(hit->t, std::numeric_limits<double>::infinity());
  }
  places.push_back(shaft.length());
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (const double part : {0.25, 0.5, 0.75}) {
      const double at = places[i] + part * (places[i + 1] - places[i]);
      if (distance(ray.at(at)) + shaft.radiusAt(at) < -shaft.margin()) return true;
    }
  return false;
}

bool TorusShadow::passesBy(const Shaft& shaft, bool own) const {
  const Ray way{shaft.center(), shaft.towards()};
  double at = 0;
  bool hasLeft = own;
  constexpr int mostSteps = 100;
  for (int step = 0; step < mostSteps; ++step) {
    const double radius = shaft.radiusAt(at) + shaft.margin();
    const double room = distance(way.at(at)) - radius;
    const bool isOutside = room > 0.1 * radius;
    if (!isOutside && !hasLeft) return false;
    hasLeft = true;
    // Either a step through empty space, or one of half a ball on which the distance grows.
    const double half = 0.25 * radius;
    if (!isOutside && !(leastSlope(way.at(at + half), radius + half, shaft, 1) > 0)) return false;
    at += isOutside ? 0.99 * room : 2 * half;
    if (at >= shaft.length()) return true;
  }
  return false;
}

/// At least what the distance, times the sign, changes by per way towards the light in a ball. Its
/// slope turns by no more than the way over the distance from the torus's circle, or from its axis.
double TorusShadow::leastSlope(const glm::dvec3& center, double radius, const Shaft& shaft,
                               double sign) const {
  const glm::dvec3 own = solid_.placement().toOwnPoint(center), away = fromCircle(shape_, own);
  const double fromTheCircle = glm::length(away);
  const double nearest = std::min(fromTheCircle, distanceFromAxis(own)) - radius;
  if (!(nearest > 0)) return -1;
  const glm::dvec3 towards = solid_.placement().toOwnDirection(shaft.towards());
  return sign * glm::dot(away, towards) / fromTheCircle - radius / nearest - shaft.spread();
}

}  // namespace haarlight
