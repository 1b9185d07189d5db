#include "light/builtin_lights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "image/color.h"
#include "light/analytic_environment.h"
#include "light/azimuth.h"
#include "light/sky_environment.h"

namespace haarlight {

namespace {

const glm::dvec3 white(1.0), warmWhite(1.0, 0.80, 0.55), amber(1.0, 0.55, 0.20),
    coldWhite(0.70, 0.85, 1.0), blue(0.35, 0.55, 1.0), skyBlue(0.45, 0.65, 1.0),
    haze(0.80, 0.90, 1.0), earth(0.60, 0.50, 0.40);

/// The tint, scaled to a luminance.
glm::dvec3 tinted(const glm::dvec3& tint, double value) {
  return tint * (value / luminance(tint));
}

struct LobeShape {
  double elevation, azimuth, radius;  ///< degrees, as in directionAt
  double exponent;
};

/// A lobe that gives a floor this irradiance (as luminance).
Lobe makeLobe(const LobeShape& shape, const glm::dvec3& tint, double floorIrradiance) {
  Lobe lobe{directionAt(shape.azimuth, shape.elevation), std::cos(glm::radians(shape.radius)),
            shape.exponent, tint};
  lobe.peak *= floorIrradiance / luminance(lobe.floorIrradiance());
  return lobe;
}

std::unique_ptr<const Environment> makeLamps() {
  return std::make_unique<AnalyticEnvironment>(
      "builtin:lamps (six lamps of 1.2° to 9° radius, dim sky)",
      SkyGradient{tinted(earth, 0.03), tinted(skyBlue, 0.06), tinted(skyBlue, 0.15)},
      std::vector<Lobe>{
          makeLobe({42, 40, 1.5, 1}, warmWhite, 1.65), makeLobe({58, -100, 4, 1}, coldWhite, 0.42),
          makeLobe({30, 115, 2.5, 1}, amber, 0.20), makeLobe({66, 165, 9, 1}, white, 0.30),
          makeLobe({36, -35, 1.2, 1}, blue, 0.12), makeLobe({24, -155, 3, 1}, amber, 0.08)});
}

std::unique_ptr<const Environment> makeSky() {
  return std::make_unique<AnalyticEnvironment>(
      "builtin:sky (sun glow of 55° radius, bright sky)",
      SkyGradient{tinted(earth, 0.12), tinted(haze, 0.40), tinted(skyBlue, 0.35)},
      std::vector<Lobe>{makeLobe({55, 40, 55, 2}, warmWhite, 2.0)});
}

std::unique_ptr<const Environment> makeConstant() {
  return std::make_unique<AnalyticEnvironment>(
      "builtin:constant (radiance 1)", SkyGradient{white, white, white}, std::vector<Lobe>{});
}

struct BuiltinLight {
  const char* name;
  std::unique_ptr<const Environment> (*make)();
};

constexpr BuiltinLight builtinLights[] = {
    {"builtin:lamps", makeLamps}, {"builtin:sky", makeSky}, {"builtin:constant", makeConstant}};

}  // namespace

std::vector<std::string> builtinLightNames() {
  std::vector<std::string> names;
  for (const BuiltinLight& light : builtinLights) names.push_back(light.name);
  for (const SkyModel& sky : skyModels()) names.push_back(sky.name);
  return names;
}

std::unique_ptr<const Environment> makeBuiltinLight(const std::string& name,
                                                    const SkySettings& skySettings) {
  for (const BuiltinLight& light : builtinLights)
    if (name == light.name) return light.make();
  if (const SkyModel* sky = findSky(name))
    return std::make_unique<SkyEnvironment>(*sky, skySettings);
  throw InputError(fmt::format("there is no light \"{}\"; the built-in ones are {}", name,
                               fmt::join(builtinLightNames(), ", ")));
}

}  // namespace haarlight
