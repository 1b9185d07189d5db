#pragma once

#include <glm/vec3.hpp>

#include "shadow/shadow_object.h"
#include "solids/solid.h"

namespace haarlight {

/// What the distance from a torus tells about its shadow: the distance changes by no more than the
/// way one goes.
class TorusShadow {
 public:
  /// The solid must be a torus.
  explicit TorusShadow(const Solid& solid);

  /// Distance from the surface; negative inside.
  double distance(const glm::dvec3& point) const;

  /// The point of the surface next to a point.
  glm::dvec3 nearestSurfacePoint(const glm::dvec3& point) const;

  /// `all` when at some place the ball around the cell lies within the torus; `none` when it comes
  /// to the light without having met it. With `own` the way begins on the surface: `all` also where
  /// that faces away from the light; and while the distance grows along all ways to the light, they
  /// do not meet the surface again.
  CellShadow on(const Shaft& shaft, bool own) const;

 private:
  bool liesWithin(const Shaft& shaft) const;
  bool passesBy(const Shaft& shaft, bool own) const;
  double leastSlope(const glm::dvec3& center, double radius, const Shaft& shaft, double sign) const;

  Solid solid_;
  TorusShape shape_;
};

}  // namespace haarlight
