#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace haarlight {

/// A ball in double precision, as fitting uses it before the result becomes a Sphere.
struct Ball {
  glm::dvec3 center{0};
  double radius = 0;
};

/// The smallest ball that contains all points (Welzl 1991); radius 0 for a single point or none.
Ball minimumEnclosingBall(std::span<const glm::vec3> points);

}  // namespace haarlight
