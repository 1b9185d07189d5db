#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

namespace haarlight {

/// A closed box whose faces are parallel to the coordinate planes; it may be flat. Without any
/// point at first.
struct AxisBox {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  bool isEmpty() const { return !glm::all(glm::lessThanEqual(lower, upper)); }

  bool contains(const glm::dvec3& point) const {
    return glm::all(glm::lessThanEqual(lower, point)) && glm::all(glm::lessThanEqual(point, upper));
  }

  glm::dvec3 center() const { return 0.5 * lower + 0.5 * upper; }

  /// The smallest box that holds both.
  friend AxisBox united(const AxisBox& a, const AxisBox& b) {
    return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
  }

  // Without branches, as what comes of them cannot be foretold.

  /// Whether they have a point in common.
  friend bool overlap(const AxisBox& a, const AxisBox& b) {
    return bool(int(a.lower.x <= b.upper.x) & int(a.lower.y <= b.upper.y) &
                int(a.lower.z <= b.upper.z) & int(b.lower.x <= a.upper.x) &
                int(b.lower.y <= a.upper.y) & int(b.lower.z <= a.upper.z));
  }

  /// Whether all of the first box lies in the second.
  friend bool liesWithin(const AxisBox& inner, const AxisBox& outer) {
    return bool(int(outer.lower.x <= inner.lower.x) & int(outer.lower.y <= inner.lower.y) &
                int(outer.lower.z <= inner.lower.z) & int(inner.upper.x <= outer.upper.x) &
                int(inner.upper.y <= outer.upper.y) & int(inner.upper.z <= outer.upper.z));
  }

  bool operator==(const AxisBox&) const = default;
};

}  // namespace haarlight
