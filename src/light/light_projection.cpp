#include "light/light_projection.h"

#include <cmath>
#include <glm/trigonometric.hpp>

#include "image/color.h"

namespace haarlight {

LightProjection projectToCube(const Environment& environment, const glm::mat3& rotation,
                              float scale) {
  const LightIntegrals integrals = environment.integrate(glm::dmat3(rotation));
  LightProjection projection{};
  projection.sourcePower = double(scale) * integrals.sourcePower;
  for (int texel = 0; texel < texelCount; ++texel) {
    const glm::dvec3 mean = integrals.radiance[texel] / integrals.solidAngle[texel];
    projection.cube[texel] = glm::vec3(double(scale) * mean);
    projection.cubePower += glm::dvec3(projection.cube[texel]) * texelSolidAngle(texel);
  }
  const double source = luminance(projection.sourcePower);
  projection.powerRatio = source > 0 ? luminance(projection.cubePower) / source : 1;
  return projection;
}

glm::mat3 yawRotation(double degrees) {
  const double angle = glm::radians(degrees);
  const float c = float(std::cos(angle)), s = float(std::sin(angle));
  return glm::mat3(glm::vec3(c, 0, -s), glm::vec3(0, 1, 0), glm::vec3(s, 0, c));
}

}  // namespace haarlight
