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

  /// Whether they have a point in common.
  friend bool overlap(const AxisBox& a, const AxisBox& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
  }

  /// Whether all of the first box lies in the second.
  friend bool liesWithin(const AxisBox& inner, const AxisBox& outer) {
    return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
           glm::all(glm::lessThanEqual(inner.upper, outer.upper));
  }

  bool operator==(const AxisBox&) const = default;
};

}  // namespace haarlight
