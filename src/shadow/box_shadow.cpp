#include "shadow/box_shadow.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace haarlight {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// More than rounding needs: what Solid::contains still takes for a point of the surface must count
/// here too.
constexpr double relativeMargin = 2e-12;

struct Interval {
  double low = -infinity, high = infinity;

  /// Keeps the u for which a + b u ≥ 0.
  void keepNotNegative(double a, double b) {
    if (b > 0)
      low = std::max(low, -a / b);
    else if (b < 0)
      high = std::min(high, -a / b);
    else if (a < 0)
      *this = {infinity, -infinity};
  }

  bool reaches(double from, double to) const { return std::max(low, from) <= std::min(high, to); }
};

/// The way of points to the light: u from 0 to `end`.
struct WayToLight {
  const PointLight* point;
  const DirectionalLight* directional;

  explicit WayToLight(const ShadowLight& light)
      : point(std::get_if<PointLight>(&light)),
        directional(std::get_if<DirectionalLight>(&light)) {}

  double end() const { return point ? 1 : infinity; }
  glm::dvec3 velocity(const glm::dvec3& start) const {
    return point ? point->position - start : directional->towards;
  }
};

double largestCoordinate(const AxisBox& box) {
  const glm::dvec3 largest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  return std::max({largest.x, largest.y, largest.z});
}

/// The u at which the receiver on its way meets the caster.
Interval meetings(const AxisBox& caster, const AxisBox& receiver, const WayToLight& way) {
  const glm::dvec3 lower = way.velocity(receiver.lower), upper = way.velocity(receiver.upper);
  Interval result;
  for (int axis = 0; axis < 3; ++axis) {
    result.keepNotNegative(caster.upper[axis] - receiver.lower[axis], -lower[axis]);
    result.keepNotNegative(receiver.upper[axis] - caster.lower[axis], upper[axis]);
  }
  return result;
}

}  // namespace

BoxShadow shadowOf(const AxisBox& caster, const AxisBox& receiver, const ShadowLight& light) {
  if (caster.isEmpty() || receiver.isEmpty()) return BoxShadow::none;
  const WayToLight way(light);
  double scale = largestCoordinate(united(caster, receiver));
  if (way.point)
    scale = std::max(scale, largestCoordinate({way.point->position, way.point->position}));
  const double margin = relativeMargin * scale;
  const AxisBox grown{receiver.lower - margin, receiver.upper + margin};

  const Interval found = meetings({caster.lower - margin, caster.upper + margin}, grown, way);
  if (!found.reaches(0, way.end())) return BoxShadow::none;
  return found.reaches(-infinity, 0) ? BoxShadow::some : BoxShadow::behind;
}

}  // namespace haarlight
