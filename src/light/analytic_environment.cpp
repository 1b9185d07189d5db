#include "light/analytic_environment.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "base/parallel.h"
#include "cube/cube_map.h"

namespace haarlight {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int samplesPerSide = 32;

}  // namespace

glm::dvec3 SkyGradient::radiance(double y) const {
  return glm::mix(horizon, y < 0 ? ground : zenith, std::abs(y));
}

glm::dvec3 SkyGradient::power() const {
  return pi * (ground + 2.0 * horizon + zenith);
}

glm::dvec3 SkyGradient::floorIrradiance() const {
  return pi / 3 * (horizon + 2.0 * zenith);
}

glm::dvec3 Lobe::radiance(const glm::dvec3& unitDirection) const {
  const double height = (glm::dot(direction, unitDirection) - cosRadius) / (1 - cosRadius);
  return height > 0 ? peak * std::pow(height, exponent) : glm::dvec3(0.0);
}

glm::dvec3 Lobe::power() const {
  return peak * (2 * pi * (1 - cosRadius) / (exponent + 1));
}

glm::dvec3 Lobe::floorIrradiance() const {
  const double meanCosine = 1 - (1 - cosRadius) / (exponent + 2);
  return power() * (meanCosine * direction.y);
}

AnalyticEnvironment::AnalyticEnvironment(std::string description, SkyGradient sky,
                                         std::vector<Lobe> lobes)
    : description_(std::move(description)), sky_(sky), lobes_(std::move(lobes)) {}

glm::dvec3 AnalyticEnvironment::exactRadiance(const glm::dvec3& unitDirection) const {
  glm::dvec3 sum = sky_.radiance(unitDirection.y);
  for (const Lobe& lobe : lobes_) sum += lobe.radiance(unitDirection);
  return sum;
}

glm::vec3 AnalyticEnvironment::radiance(const glm::vec3& direction) const {
  return exactRadiance(glm::normalize(glm::dvec3(direction)));
}

std::vector<Lobe> AnalyticEnvironment::lobesWithin(const glm::dvec3& unitDirection,
                                                   double radians) const {
  std::vector<Lobe> near;
  for (const Lobe& lobe : lobes_)
    if (std::acos(std::clamp(glm::dot(lobe.direction, unitDirection), -1.0, 1.0)) <
        std::acos(lobe.cosRadius) + radians)
      near.push_back(lobe);
  return near;
}

LightIntegrals AnalyticEnvironment::integrate(const glm::dmat3& rotation) const {
  const glm::dmat3 toLight = glm::transpose(rotation);
  constexpr double step = 2.0 / (faceSize * samplesPerSide);
  LightIntegrals integrals;
  const auto integrateTexel = [&](int texel) {
    const int face = texel / texelsPerFace, row = texel / faceSize % faceSize,
              column = texel % faceSize;
    // No point of a texel is farther from its centre than half its diagonal on the cube.
    const auto lobes = lobesWithin(toLight * texelDirection(texel), std::numbers::sqrt2 / faceSize);
    for (int i = 0; i < samplesPerSide * samplesPerSide; ++i) {
      const double s = -1 + (column * samplesPerSide + i % samplesPerSide + 0.5) * step;
      const double t = -1 + (row * samplesPerSide + i / samplesPerSide + 0.5) * step;
      const glm::dvec3 place = cubeDirection({face, s, t});
      const double distance = glm::length(place);
      const double solidAngle = step * step / (distance * distance * distance);
      const glm::dvec3 direction = toLight * (place / distance);
      glm::dvec3 radiance = sky_.radiance(direction.y);
      for (const Lobe& lobe : lobes) radiance += lobe.radiance(direction);
      integrals.radiance[texel] += solidAngle * radiance;
      integrals.solidAngle[texel] += solidAngle;
    }
  };
  parallelFor(texelCount, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t texel = begin; texel < end; ++texel) integrateTexel(int(texel));
  });
  integrals.sourcePower = sky_.power();
  for (const Lobe& lobe : lobes_) integrals.sourcePower += lobe.power();
  return integrals;
}

}  // namespace haarlight
