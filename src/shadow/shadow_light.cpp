#include "shadow/shadow_light.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"

namespace haarlight {

namespace {

bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

struct LightCheck {
  void operator()(const PointLight& light) const {
    if (!isFinite(light.position))
      throw InputError("point light: its position must be three finite numbers");
  }
  void operator()(const DirectionalLight& light) const {
    if (!isFinite(light.towards) || light.towards == glm::dvec3(0))
      throw InputError(
          "directional light: the direction towards it must be three finite numbers, not all 0");
  }
};

}  // namespace

void checkLight(const ShadowLight& light) {
  std::visit(LightCheck{}, light);
}

Ray segmentToLight(const glm::dvec3& point, const ShadowLight& light) {
  if (const auto* source = std::get_if<PointLight>(&light))
    return {point, source->position - point, 0, 1};
  return {point, std::get<DirectionalLight>(light).towards};
}

}  // namespace haarlight
