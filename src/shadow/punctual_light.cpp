#include "shadow/punctual_light.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace haarlight {

glm::dvec3 irradianceOf(const PunctualLight& light, const glm::dvec3& point,
                        const glm::dvec3& normal) {
  const glm::dvec3 towards = segmentToLight(point, light.light).direction;
  const double length = glm::length(towards);
  if (length == 0) return glm::dvec3(0);
  const double cosine = std::max(0.0, glm::dot(normal, towards) / length);
  const bool isPoint = std::holds_alternative<PointLight>(light.light);
  return cosine / (isPoint ? length * length : 1) * glm::dvec3(light.strength);
}

}  // namespace haarlight
