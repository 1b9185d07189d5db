#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "visibility/sphere.h"

namespace haarlight {

/// A ball in double precision, as fitting uses it before the result becomes a Sphere.
struct Ball {
  glm::dvec3 center{0};
  double radius = 0;
};

inline Ball ballOf(const glm::vec3& point) {
  return {point, 0};
}
inline Ball ballOf(const Sphere& sphere) {
  return {sphere.center, sphere.radius};
}

/// Distance from `center` to the farthest point of the ball.
inline double reach(const Ball& ball, const glm::dvec3& center) {
  return glm::distance(ball.center, center) + ball.radius;
}

/// The smallest ball that contains all points, or all spheres, up to rounding: it grows by what
/// lies farthest from its centre until nothing sticks out (Fischer and Gärtner 2003, who show why
/// Welzl's recursion is right for points only). Radius 0 around nothing.
Ball minimumEnclosingBall(std::span<const glm::vec3> points);
Ball minimumEnclosingBall(std::span<const Sphere> spheres);

}  // namespace haarlight
