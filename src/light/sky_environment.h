#pragma once

#include "light/analytic_environment.h"
#include "light/sky_model.h"
#include "light/sky_settings.h"

namespace haarlight {

/// A grey sky above a plain ground: radiance zenithRadiance · SkyModel::relativeLuminance from the
/// horizon up, plus the sun's disc of 0.2665° radius; below, the radiance of a Lambertian ground in
/// the open, groundAlbedo · horizontal irradiance / π. The horizon does not cut the disc.
///
/// Texels are sampled at 16×16 places, but for the disc, which is smaller than they are: it is a
/// polygon of 64 corners cut exactly along the texels' borders, so it gives the cube its whole
/// power wherever it stands.
class SkyEnvironment final : public Environment {
 public:
  /// Throws InputError when a setting is out of range or not a number.
  SkyEnvironment(const SkyModel& model, const SkySettings& settings);

  glm::vec3 radiance(const glm::vec3& direction) const override;
  std::string description() const override;
  LightIntegrals integrate(const glm::dmat3& rotation) const override;

  double zenithRadiance() const { return zenithRadiance_; }
  /// Irradiance of a floor (normal +Y) by the sky without the disc.
  double skyIrradiance() const { return skyIrradiance_; }
  /// Irradiance of a surface that faces the sun by the disc alone: sunDisc · skyIrradiance times
  /// the ratio of the two on a clear day by the sun's elevation h in the formulas of IES RP-21
  /// (1984): 128 exp(−0.21 / sin h) klx of sun to 0.8 + 15.5 √sin h klx of sky. So the sun fades
  /// as it sets and has gone at the horizon.
  double sunIrradiance() const { return sunIrradiance_; }

 private:
  glm::dvec3 radianceWithoutDisc(const glm::dvec3& unitDirection) const;

  SkyModel model_;
  SkySettings settings_;
  Lobe disc_;
  double zenithRadiance_, skyIrradiance_, sunIrradiance_;
  double scale_;  ///< zenithRadiance over gradation and indicatrix at the zenith
  glm::dvec3 ground_, power_;
};

}  // namespace haarlight
