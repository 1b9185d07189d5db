#pragma once

#include <glm/vec3.hpp>
#include <limits>

namespace haarlight {

/// The points origin + t · direction with near ≤ t ≤ far. The direction need not be a unit vector:
/// a ray from a point to a light may have the light at t = 1.
struct Ray {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, 1};
  double near = 0;
  double far = std::numeric_limits<double>::infinity();

  glm::dvec3 at(double t) const { return origin + t * direction; }
};

}  // namespace haarlight
