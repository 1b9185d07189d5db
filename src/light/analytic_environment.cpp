#include "light/analytic_environment.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "light/texel_sampling.h"

namespace haarlight {

namespace {

constexpr double pi = std::numbers::pi;

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
  constexpr int samplesPerSide = 32;
  // No point of a texel is farther from its centre than half its diagonal on the cube.
  constexpr double texelRadius = std::numbers::sqrt2 / faceSize;
  LightIntegrals integrals = sampleTexels(rotation, samplesPerSide, [&](const glm::dvec3& center) {
    return [this, lobes = lobesWithin(center, texelRadius)](const glm::dvec3& direction) {
      glm::dvec3 radiance = sky_.radiance(direction.y);
      for (const Lobe& lobe : lobes) radiance += lobe.radiance(direction);
      return radiance;
    };
  });
  integrals.sourcePower = sky_.power();
  for (const Lobe& lobe : lobes_) integrals.sourcePower += lobe.power();
  return integrals;
}

}  // namespace haarlight
