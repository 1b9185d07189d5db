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

/// The mean of the corners of what a box cuts out of a triangle: a point of both. Nothing when they
/// have no point in common.
std::optional<glm::dvec3> pointInBoth(const TriangleCorners& triangle, const AxisBox& box);

}  // namespace haarlight
