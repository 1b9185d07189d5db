#pragma once

#include <cmath>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace haarlight {

/// Unit direction by azimuth, counted from +Z towards +X as yawRotation turns (counter-clockwise
/// seen from above), and elevation above the horizon, in degrees.
inline glm::dvec3 directionAt(double azimuthDegrees, double elevationDegrees) {
  const double elevation = glm::radians(elevationDegrees), azimuth = glm::radians(azimuthDegrees);
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

}  // namespace haarlight
