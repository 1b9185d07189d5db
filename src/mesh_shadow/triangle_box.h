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
struct BoxedTriangle {
  TriangleCorners corners;
  AxisBox bounds;

  explicit BoxedTriangle(const TriangleCorners& triangle);

  /// The same as triangleMeetsBox.
  bool meets(const AxisBox& box) const {
    return overlap(bounds, box) && (liesWithin(bounds, box) || triangleMeetsBox(corners, box));
  }
};

/// A point of a triangle that lies in a box too: the triangle's middle, or else the mean of the
/// corners of what the box cuts out of it. Nothing when they have no point in common.
std::optional<glm::dvec3> pointInBoth(const TriangleCorners& triangle, const AxisBox& box);

}  // namespace haarlight
