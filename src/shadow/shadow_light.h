#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <variant>

#include "solids/ray.h"

namespace haarlight {

struct PointLight {
  glm::dvec3 position{0};

  bool operator==(const PointLight&) const = default;
};

/// A light so far away that its rays are parallel.
struct DirectionalLight {
  glm::dvec3 towards{0, 1, 0};  ///< from the scene to the light; not zero, of any length

  bool operator==(const DirectionalLight&) const = default;
};

/// A light whose shadows have hard edges.
using ShadowLight = std::variant<PointLight, DirectionalLight>;

/// Throws InputError when a number is not finite or a direction is zero.
void checkLight(const ShadowLight& light);

/// The way of light from a point, t from 0 to a point light at 1, or to infinity.
Ray segmentToLight(const glm::dvec3& point, const ShadowLight& light);

/// Whether a surface lies in its own (attached) shadow: its normal points away from the light, or
/// at a right angle.
inline bool facesAway(const glm::dvec3& normal, const glm::dvec3& point, const ShadowLight& light) {
  const auto* source = std::get_if<PointLight>(&light);
  return glm::dot(normal, source ? source->position - point
                                 : std::get_if<DirectionalLight>(&light)->towards) <= 0;
}

}  // namespace haarlight
