#pragma once

#include <glm/vec3.hpp>

#include "shadow/shadow_light.h"

namespace haarlight {

/// A light whose shadows have hard edges, with its strength in linear RGB: a point light's
/// intensity (W/sr), a directional light's irradiance on what faces it (W/m²).
struct PunctualLight {
  ShadowLight light;
  glm::vec3 strength{1};

  bool operator==(const PunctualLight&) const = default;
};

/// What it brings to a surface that nothing stands before; `normal` is a unit vector. 0 where the
/// surface faces away, and at a point light.
glm::dvec3 irradianceOf(const PunctualLight& light, const glm::dvec3& point,
                        const glm::dvec3& normal);

}  // namespace haarlight
