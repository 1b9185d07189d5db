#include "light/sky_environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "base/error.h"
#include "light/azimuth.h"
#include "light/texel_sampling.h"
#include "sh/quadrature.h"

namespace haarlight {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double discRadiusDegrees = 0.2665;

void requireWithin(double value, double minimum, double maximum, const char* what) {
  if (!(value >= minimum && value <= maximum))
    throw InputError(
        fmt::format("a sky's {} must be {:g} to {:g}, not {:g}", what, minimum, maximum, value));
}

const SkySettings& checked(const SkySettings& settings) {
  requireWithin(settings.sunElevationDegrees, 0, 90, "sun elevation in degrees");
  requireWithin(settings.zenithRadiance.value_or(0), 0, 1e6, "zenith radiance");
  requireWithin(settings.sunDisc, 0, 100, "sun disc");
  for (int c = 0; c < 3; ++c) requireWithin(settings.groundAlbedo[c], 0, 1, "ground albedo");
  if (!std::isfinite(settings.sunAzimuthDegrees))
    throw InputError("a sky's sun azimuth in degrees must be a number");
  return settings;
}

/// Irradiance of a surface facing the sun over the sky's of a floor on a clear day.
double clearDayRatio(double sinElevation) {
  return 128 * std::exp(-0.21 / sinElevation) / (0.8 + 15.5 * std::sqrt(sinElevation));
}

/// Integrals of the relative luminance over the upper hemisphere.
struct HemisphereIntegrals {
  double power = 0;       ///< ∫ l dω
  double irradiance = 0;  ///< ∫ l cos Z dω
};

/// The sky is symmetric about the sun's meridian, so half of it is looked at.
HemisphereIntegrals integrateSky(const SkyModel& model, double sunZenithDistance) {
  static const GaussLegendreRule rule = gaussLegendre(160);
  constexpr int azimuths = 320;
  HemisphereIntegrals sum;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double zenithDistance = pi / 4 * (1 + rule.nodes[i]);
    const double cosine = std::cos(zenithDistance), sine = std::sin(zenithDistance);
    double ring = 0;
    for (int k = 0; k < azimuths; ++k) {
      const double cosSunAngle =
          cosine * std::cos(sunZenithDistance) +
          sine * std::sin(sunZenithDistance) * std::cos(pi * (k + 0.5) / azimuths);
      ring += model.relativeLuminance(cosine, std::acos(std::clamp(cosSunAngle, -1.0, 1.0)),
                                      sunZenithDistance);
    }
    const double power = ring * sine * (pi / 4 * rule.weights[i]) * (2 * pi / azimuths);
    sum.power += power;
    sum.irradiance += power * cosine;
  }
  return sum;
}

/// What the disc alone adds to each texel.
CubeImage<glm::dvec3> discIntegrals(const Lobe& disc, const glm::dmat3& rotation) {
  constexpr int corners = 64;
  const glm::dvec3 center = rotation * disc.direction;
  const glm::dvec3 aside = std::abs(center.y) < 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(aside, center)), v = glm::cross(center, u);
  const double sine = std::sqrt(1 - disc.cosRadius * disc.cosRadius);
  const auto corner = [&](int i) {
    const double angle = -2 * pi * i / corners;  // clockwise
    return disc.cosRadius * center + sine * (std::cos(angle) * u + std::sin(angle) * v);
  };
  double polygonSolidAngle = 0;
  LightIntegrals sum;
  for (int i = 0; i < corners; i += 2) {
    const SphericalQuadrilateral wedge{center, corner(i), corner(i + 1), corner(i + 2)};
    polygonSolidAngle += solidAngle(wedge);
    sum.addQuadrilateral(wedge, glm::dvec3(1.0));
  }
  for (glm::dvec3& texel : sum.radiance.texels) texel *= disc.power() / polygonSolidAngle;
  return sum.radiance;
}

}  // namespace

SkyEnvironment::SkyEnvironment(const SkyModel& model, const SkySettings& settings)
    : model_(model),
      settings_(checked(settings)),
      disc_{directionAt(settings.sunAzimuthDegrees, settings.sunElevationDegrees),
            std::cos(glm::radians(discRadiusDegrees)),
            0,
            {}} {
  const double sunZenithDistance = glm::radians(90 - settings.sunElevationDegrees);
  const HemisphereIntegrals relative = integrateSky(model, sunZenithDistance);
  const double sinElevation = disc_.direction.y;
  const double sunRatio = settings.sunDisc * clearDayRatio(sinElevation);
  const double relativeFloor = relative.irradiance * (1 + sunRatio * sinElevation);
  zenithRadiance_ = settings.zenithRadiance.value_or(pi / relativeFloor);
  scale_ = zenithRadiance_ / (model.gradation(1) * model.indicatrix(sunZenithDistance));
  skyIrradiance_ = zenithRadiance_ * relative.irradiance;
  sunIrradiance_ = sunRatio * skyIrradiance_;
  const double sineRadius = std::sin(glm::radians(discRadiusDegrees));
  disc_.peak = glm::dvec3(sunIrradiance_ / (pi * sineRadius * sineRadius));
  ground_ = settings.groundAlbedo * (zenithRadiance_ * relativeFloor / pi);
  power_ = zenithRadiance_ * relative.power + 2 * pi * ground_ + disc_.power();
}

glm::dvec3 SkyEnvironment::radianceWithoutDisc(const glm::dvec3& unitDirection) const {
  if (unitDirection.y < 0) return ground_;
  const double cosZenithDistance = std::abs(unitDirection.y);  // −0 would divide to +∞
  const double cosSunAngle = std::clamp(glm::dot(disc_.direction, unitDirection), -1.0, 1.0);
  return glm::dvec3(scale_ * model_.gradation(cosZenithDistance) *
                    model_.indicatrix(std::acos(cosSunAngle)));
}

glm::vec3 SkyEnvironment::radiance(const glm::vec3& direction) const {
  const glm::dvec3 unitDirection = glm::normalize(glm::dvec3(direction));
  return radianceWithoutDisc(unitDirection) + disc_.radiance(unitDirection);
}

std::string SkyEnvironment::description() const {
  return fmt::format("{} ({}; sun at azimuth {:g}°, elevation {:g}°{})", model_.name, model_.title,
                     settings_.sunAzimuthDegrees, settings_.sunElevationDegrees,
                     settings_.sunDisc > 0 ? ", with its disc" : "");
}

LightIntegrals SkyEnvironment::integrate(const glm::dmat3& rotation) const {
  constexpr int samplesPerSide = 16;
  LightIntegrals integrals = sampleTexels(rotation, samplesPerSide, [&](const glm::dvec3&) {
    return [&](const glm::dvec3& direction) { return radianceWithoutDisc(direction); };
  });
  if (settings_.sunDisc > 0) {
    const CubeImage<glm::dvec3> disc = discIntegrals(disc_, rotation);
    // The samples measure a texel's solid angle almost exactly; means are divided by what they say.
    for (int texel = 0; texel < texelCount; ++texel)
      integrals.radiance[texel] +=
          disc[texel] * (integrals.solidAngle[texel] / texelSolidAngle(texel));
  }
  integrals.sourcePower = power_;
  return integrals;
}

}  // namespace haarlight
