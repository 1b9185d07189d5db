#pragma once

#include "light/environment.h"

namespace haarlight {

/// A light on the cube and what the projection kept of its power.
struct LightProjection {
  RadianceCube cube;
  glm::dvec3 sourcePower;  ///< ∫ L dω of the (scaled) light itself, per channel
  glm::dvec3 cubePower;    ///< Σ texel · solid angle
  double powerRatio;       ///< luminance of cubePower over that of sourcePower; 1 for a black light
};

/// Mean radiance per texel of the light times `scale`, turned so that what came from d comes from
/// rotation · d (an orthonormal matrix, no reflection).
LightProjection projectToCube(const Environment& environment,
                              const glm::mat3& rotation = glm::mat3(1.0f), float scale = 1.0f);

/// Rotation by an angle about +Y, from +Z towards +X.
glm::mat3 yawRotation(double degrees);

}  // namespace haarlight
