#pragma once

/// What a solid may be, in its own coordinates: around the origin, and around the y axis where it
/// has one. All are closed sets.

#include <glm/vec3.hpp>
#include <variant>

namespace haarlight {

struct SphereShape {
  double radius = 1;
};

/// x²/a² + y²/b² + z²/c² ≤ 1 with radii (a, b, c).
struct EllipsoidShape {
  glm::dvec3 radii{1};
};

/// |x| ≤ a, |y| ≤ b, |z| ≤ c with half sizes (a, b, c).
struct BoxShape {
  glm::dvec3 halfSizes{1};
};

/// x² + z² ≤ radius², |y| ≤ height/2: with its two caps.
struct CylinderShape {
  double radius = 1;
  double height = 1;
};

/// |y| ≤ height/2, and the radius goes from `radius` at the bottom to `topRadius` at the top in
/// proportion to y: a cone with its cap, or the frustum of one.
struct ConeShape {
  double radius = 1;
  double height = 1;
  double topRadius = 0;  ///< may be larger than `radius`
};

/// All points within `minorRadius` of the circle of radius `majorRadius` in the plane y = 0.
struct TorusShape {
  double majorRadius = 1;
  double minorRadius = 0.25;
};

using Shape =
    std::variant<SphereShape, EllipsoidShape, BoxShape, CylinderShape, ConeShape, TorusShape>;

}  // namespace haarlight
