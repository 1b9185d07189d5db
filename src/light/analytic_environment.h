#pragma once

#include <vector>

#include "light/environment.h"

namespace haarlight {

/// Radiance by height y of the unit direction: linear from ground (y = −1) over horizon (0) to
/// zenith (1).
struct SkyGradient {
  glm::dvec3 ground, horizon, zenith;

  glm::dvec3 radiance(double y) const;
  glm::dvec3 power() const;  ///< ∫ L dω over the sphere
  /// Irradiance of a floor (normal +Y).
  glm::dvec3 floorIrradiance() const;
};

/// A round source: peak · ((cos θ − cos r) / (1 − cos r))^exponent within the angle r of its
/// direction; it fades to 0 at its rim.
struct Lobe {
  glm::dvec3 direction;
  double cosRadius;
  double exponent;
  glm::dvec3 peak;

  glm::dvec3 radiance(const glm::dvec3& unitDirection) const;
  glm::dvec3 power() const;  ///< ∫ L dω
  /// Irradiance of a floor (normal +Y) when all of the lobe is above the horizon.
  glm::dvec3 floorIrradiance() const;
};

/// A light given by formula: a gradient and lobes. Its integrals sample every texel at 32×32
/// places weighted by solid angle; its power is in closed form.
class AnalyticEnvironment final : public Environment {
 public:
  AnalyticEnvironment(std::string description, SkyGradient sky, std::vector<Lobe> lobes);

  glm::vec3 radiance(const glm::vec3& direction) const override;
  std::string description() const override { return description_; }
  LightIntegrals integrate(const glm::dmat3& rotation) const override;

 private:
  /// Lobes that reach some direction within an angle of this one.
  std::vector<Lobe> lobesWithin(const glm::dvec3& unitDirection, double radians) const;
  glm::dvec3 exactRadiance(const glm::dvec3& unitDirection) const;

  std::string description_;
  SkyGradient sky_;
  std::vector<Lobe> lobes_;
};

}  // namespace haarlight
