#pragma once

#include "solids/shapes.h"

namespace haarlight {

/// The smallest and largest measure of a solid. Between them, no square or fourth power that the
/// formulas need leaves the range of a double.
inline constexpr double smallestMeasure = 1e-30, largestMeasure = 1e30;

/// Throws InputError unless the shape is one that has an inside and one surface around it:
/// - every measure is a number from smallestMeasure to largestMeasure. A cone or cylinder of height
///   0, a flat ellipsoid or box, a radius of 0 leave nothing that a point could be inside of;
/// - a cone's top radius may also be 0, its apex;
/// - a torus's minor radius is at most its major: beyond, its surface would pass through itself. At
///   equality its hole is one point, which is allowed.
void checkShape(const Shape& shape);

/// "sphere", "cone", …
const char* shapeName(const Shape& shape);

}  // namespace haarlight
