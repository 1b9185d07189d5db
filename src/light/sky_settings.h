#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace haarlight {

/// What a sky leaves open.
struct SkySettings {
  /// Where the sun stands, in degrees: azimuth as in directionAt (light/azimuth.h), from +Z
  /// towards +X; elevation 0 (horizon) to 90 (zenith).
  double sunAzimuthDegrees = 40;
  double sunElevationDegrees = 45;
  /// Radiance of the zenith, 0 to 10⁶; nothing: such that sky and disc together give a floor
  /// (normal +Y) the irradiance π.
  std::optional<double> zenithRadiance;
  /// How much of the sun itself is seen beside its glow, 0 (nothing) to 100; 1: as on a clear day
  /// (SkyEnvironment::sunIrradiance).
  double sunDisc = 0;
  /// Diffuse reflectance of the ground below the horizon, 0 to 1.
  glm::dvec3 groundAlbedo{0.2, 0.2, 0.2};

  bool operator==(const SkySettings&) const = default;
};

}  // namespace haarlight
