#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "solids/axis_box.h"

namespace haarlight {

using TriangleCorners = std::array<glm::dvec3, 3>;

/// Whether a triangle and a box have a point in common: no axis separates them (Akenine-Möller
/// 2001). Triangles without an area, lines and points, count too.
bool triangleMeetsBox(const TriangleCorners& triangle, const AxisBox& box);

/// Whether a segment and a box have a point in common.
bool segmentMeetsBox(const glm::dvec3& a, const glm::dvec3& b, const AxisBox& box);

/// A triangle with its own box, by which most other boxes are told.
struct alignas(64) BoxedTriangle {
  AxisBox bounds;
  double size;  ///< the longest edge of the box
  TriangleCorners corners;

  explicit BoxedTriangle(const TriangleCorners& triangle);

  /// False only if they have no point in common. Of boxes much larger than the triangle, only the
  /// triangle's own is looked at.
  bool mayMeet(const AxisBox& box) const {
    constexpr double muchLarger = 3;
    return overlap(bounds, box) && (muchLarger * size < box.upper.x - box.lower.x ||
                                    liesWithin(bounds, box) || triangleMeetsBox(corners, box));
  }
};

/// A point of a triangle that lies in a box too: the triangle's middle, the point below the box's
/// middle, or else the mean of the corners of what the box cuts out of the triangle. Nothing when
/// they have no point in common.
std::optional<glm::dvec3> pointInBoth(const TriangleCorners& triangle, const AxisBox& box);

}  // namespace haarlight
