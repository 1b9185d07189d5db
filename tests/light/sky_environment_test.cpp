#include "light/sky_environment.h"

#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "cube/cube_map.h"
#include "light/azimuth.h"
#include "light/builtin_lights.h"
#include "light/light_projection.h"
#include "light_test_support.h"

namespace haarlight::test {

namespace {

constexpr double pi = std::numbers::pi;

SkyEnvironment environment(const std::string& name, const SkySettings& settings) {
  const SkyModel* model = findSky("builtin:" + name);
  REQUIRE(model);
  return {*model, settings};
}

SkySettings withSun(double azimuth, double elevation, double disc = 0) {
  SkySettings settings;
  settings.sunAzimuthDegrees = azimuth;
  settings.sunElevationDegrees = elevation;
  settings.sunDisc = disc;
  return settings;
}

double at(const Environment& light, double azimuth, double elevation) {
  return light.radiance(glm::vec3(directionAt(azimuth, elevation))).g;
}

/// Irradiance of a floor, ∫ L cos over the upper texels, by their exact first moments.
double floorIrradiance(const RadianceCube& cube) {
  double sum = 0;
  for (int texel = 0; texel < texelCount; ++texel)
    if (texelDirection(texel).y > 0) sum += cube[texel].g * texelMoment(texel).y;
  return sum;
}

/// The cube's power under a uniform sky of radiance 1 over black ground, which is 2π without the
/// disc of the sun.
double powerUnderUniformSky(SkySettings settings, const glm::mat3& rotation) {
  settings.zenithRadiance = 1;
  settings.groundAlbedo = glm::dvec3(0);
  return projectToCube(environment("iso-sky-5", settings), rotation).cubePower.g;
}

}  // namespace

TEST_CASE("azimuth counts from +Z towards +X, elevation from the horizon") {
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) < 1e-15;
  };
  CHECK(near(directionAt(0, 0), {0, 0, 1}));
  CHECK(near(directionAt(90, 0), {1, 0, 0}));
  CHECK(near(directionAt(-90, 0), {-1, 0, 0}));
  CHECK(near(directionAt(17, 90), {0, 1, 0}));
  const glm::dvec3 turned = glm::dmat3(yawRotation(30)) * directionAt(10, 20);
  CHECK(glm::length(turned - directionAt(40, 20)) < 1e-7);
}

TEST_CASE("the zenith has the radiance that is asked for, in grey") {
  for (const SkyModel& model : skyModels()) {
    SkySettings settings = withSun(70, 30);
    settings.zenithRadiance = 2.5;
    const SkyEnvironment light(model, settings);
    CAPTURE(model.name);
    for (const float channel : {light.radiance({0, 3, 0}).r, light.radiance({0, 3, 0}).b})
      CHECK(channel == doctest::Approx(2.5).epsilon(1e-6));
    CHECK(light.zenithRadiance() == 2.5);
  }
}

TEST_CASE("without a zenith radiance a floor gets the irradiance pi, disc and all") {
  for (const SkyModel& model : skyModels())
    for (const double disc : {0.0, 1.0}) {
      const SkyEnvironment light(model, withSun(70, 30, disc));
      CAPTURE(model.name);
      CHECK(light.skyIrradiance() + light.sunIrradiance() * 0.5 ==
            doctest::Approx(pi).epsilon(1e-12));
    }
  for (const char* name : {"iso-sky-4", "iso-sky-14"}) {
    const auto light = makeBuiltinLight(std::string("builtin:") + name, withSun(70, 30));
    CHECK(floorIrradiance(projectToCube(*light).cube) == doctest::Approx(pi).epsilon(1e-3));
  }
}

TEST_CASE("irradiance and power in closed form: overcast and uniform") {
  SkySettings settings;
  settings.zenithRadiance = 3;
  settings.groundAlbedo = {0.1, 0.3, 0.5};
  const SkyEnvironment overcast = environment("cie-overcast", settings);
  CHECK(overcast.skyIrradiance() == doctest::Approx(7 * pi / 9 * 3).epsilon(1e-12));
  const SkyEnvironment uniform = environment("iso-sky-5", settings);
  CHECK(uniform.skyIrradiance() == doctest::Approx(pi * 3).epsilon(1e-12));
  // ∫ (1 + 2 cos Z) / 3 dω = 4π/3, and half of all directions see the ground: 2π · albedo · E / π.
  const glm::dvec3 power = overcast.integrate(glm::dmat3(1)).sourcePower;
  for (int c = 0; c < 3; ++c) {
    const double ground = settings.groundAlbedo[c] * 7 * pi / 9 * 3 / pi;
    CHECK(power[c] == doctest::Approx(4 * pi / 3 * 3 + 2 * pi * ground).epsilon(1e-12));
    CHECK(overcast.radiance({1, -0.2, 3})[c] == doctest::Approx(ground).epsilon(1e-6));
  }
}

TEST_CASE("a sky's integrals are those of a fine grid, wherever the sun stands") {
  for (const char* name : {"cie-clear", "iso-sky-8", "iso-sky-15"})
    for (const double elevation : {0.0, 37.0, 90.0}) {
      SkySettings settings = withSun(0, elevation);
      settings.zenithRadiance = 1;
      settings.groundAlbedo = glm::dvec3(0);
      const SkyEnvironment light = environment(name, settings);
      constexpr int rings = 1000, steps = 2000;
      double irradiance = 0, power = 0;
      for (int ring = 0; ring < rings; ++ring)
        for (int step = 0; step < steps; ++step) {
          const double y = (ring + 0.5) / rings, azimuth = 2 * pi * (step + 0.5) / steps;
          const double side = std::sqrt(1 - y * y);
          const float radiance =
              light.radiance(glm::vec3(side * std::sin(azimuth), y, side * std::cos(azimuth))).g;
          power += radiance;
          irradiance += radiance * y;
        }
      const double weight = 2 * pi / (double(rings) * steps);
      CAPTURE(name);
      CAPTURE(elevation);
      CHECK(light.skyIrradiance() == doctest::Approx(weight * irradiance).epsilon(1e-4));
      CHECK(light.integrate(glm::dmat3(1)).sourcePower.g ==
            doctest::Approx(weight * power).epsilon(1e-4));
    }
}

TEST_CASE("a sky is the same on both sides of the sun's meridian and turns with the sun") {
  for (const SkyModel& model : skyModels()) {
    const SkyEnvironment light(model, withSun(110, 35)), turned(model, withSun(110 + 77, 35));
    CAPTURE(model.name);
    for (const double elevation : {0.5, 20.0, 35.0, 80.0})
      for (const double aside : {0.0, 5.0, 60.0, 150.0}) {
        const double right = at(light, 110 + aside, elevation);
        CHECK(at(light, 110 - aside, elevation) == doctest::Approx(right).epsilon(1e-5));
        CHECK(at(turned, 110 + 77 + aside, elevation) == doctest::Approx(right).epsilon(1e-5));
      }
  }
  // The clear sky is brightest at the sun, and darkest about a right angle from it.
  const SkyEnvironment clear = environment("cie-clear", withSun(110, 35));
  CHECK(at(clear, 110, 35) > 5 * at(clear, 110, 80));
  CHECK(at(clear, 110, 35) > 10 * at(clear, 110 + 180, 55));
}

TEST_CASE("the horizon belongs to the sky, also where y is minus zero") {
  const SkyEnvironment light = environment("iso-sky-1", {});
  const float above = light.radiance({1, 1e-6f, 0}).g;
  CHECK(light.radiance({1, 0.0f, 0}).g == doctest::Approx(above).epsilon(1e-5));
  CHECK(light.radiance({1, -0.0f, 0}).g == doctest::Approx(above).epsilon(1e-5));
}

TEST_CASE("the cube keeps a sky's power in any rotation") {
  std::mt19937 random(1);
  for (const char* name : {"cie-overcast", "cie-clear", "iso-sky-4", "iso-sky-15"})
    for (const glm::mat3& rotation : {glm::mat3(1.0f), yawRotation(33), randomRotation(random)})
      for (const double disc : {0.0, 1.0}) {
        const LightProjection projection =
            projectToCube(environment(name, withSun(12, 40, disc)), rotation);
        CAPTURE(name);
        CHECK(projection.powerRatio == doctest::Approx(1).epsilon(1e-4));
      }
}

TEST_CASE("turning the light is moving the sun") {
  const RadianceCube turned =
      projectToCube(environment("iso-sky-13", withSun(20, 40, 1)), yawRotation(50)).cube;
  const RadianceCube moved = projectToCube(environment("iso-sky-13", withSun(70, 40, 1))).cube;
  for (int texel = 0; texel < texelCount; ++texel)
    REQUIRE(turned[texel].g == doctest::Approx(moved[texel].g).epsilon(1e-3));
}

TEST_CASE("the sun's disc gives the cube its whole power wherever it stands") {
  // Among them the middle of a face, an edge and a corner of the cube.
  const double corner = glm::degrees(std::asin(1 / std::sqrt(3.0)));
  const std::array<glm::dvec2, 7> places{
      {{0, 90}, {45, 20}, {45, corner}, {0, 45}, {-171.3, 12.7}, {1.4, 1.4}, {90, 60}}};
  std::mt19937 random(2);
  for (const glm::mat3& rotation : {glm::mat3(1.0f), randomRotation(random)}) {
    const double skyPower = powerUnderUniformSky(withSun(0, 0), rotation);
    for (const glm::dvec2& place : places) {
      const double power = powerUnderUniformSky(withSun(place.x, place.y, 1), rotation) - skyPower;
      // By the uniform sky of radiance 1 a floor gets π; ∫ L dω = 2π (1 − cos r) L and
      // E = π sin² r L for a disc of radius r.
      const double radius = glm::radians(0.2665), sine = std::sin(glm::radians(place.y));
      const double irradiance = pi * 128 * std::exp(-0.21 / sine) / (0.8 + 15.5 * std::sqrt(sine));
      const double expected =
          irradiance * 2 * (1 - std::cos(radius)) / std::pow(std::sin(radius), 2);
      CAPTURE(place.x);
      CAPTURE(place.y);
      CHECK(power == doctest::Approx(expected).epsilon(1e-4));
    }
  }
}

TEST_CASE("the disc has one radiance over its radius and none beyond") {
  SkySettings settings = withSun(25, 50, 0.5);
  settings.zenithRadiance = 1;
  const SkyEnvironment light = environment("iso-sky-5", settings);
  const double radiance =
      light.sunIrradiance() / (pi * std::pow(std::sin(glm::radians(0.2665)), 2));
  CHECK(at(light, 25, 50) == doctest::Approx(1 + radiance).epsilon(1e-6));
  CHECK(at(light, 25, 50.26) == doctest::Approx(1 + radiance).epsilon(1e-6));
  CHECK(at(light, 25, 50.28) == 1);
  settings.sunDisc = 1;
  CHECK(environment("iso-sky-5", settings).sunIrradiance() ==
        doctest::Approx(2 * light.sunIrradiance()).epsilon(1e-12));
  settings.sunElevationDegrees = 0;
  CHECK(environment("iso-sky-5", settings).sunIrradiance() == 0);
}

TEST_CASE("settings that make no sky are refused in one line") {
  const auto complaint = [](const SkySettings& settings) {
    return inputErrorOf([&] { environment("cie-clear", settings); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint(withSun(0, -0.5)) ==
        "a sky's sun elevation in degrees must be 0 to 90, not -0.5");
  CHECK(complaint(withSun(0, 90.5)) ==
        "a sky's sun elevation in degrees must be 0 to 90, not 90.5");
  CHECK(complaint(withSun(0, nan)) == "a sky's sun elevation in degrees must be 0 to 90, not nan");
  CHECK(complaint(withSun(nan, 10)) == "a sky's sun azimuth in degrees must be a number");
  CHECK(complaint(withSun(0, 10, -1)) == "a sky's sun disc must be 0 to 100, not -1");
  SkySettings settings;
  settings.zenithRadiance = -2;
  CHECK(complaint(settings) == "a sky's zenith radiance must be 0 to 1e+06, not -2");
  settings = {};
  settings.groundAlbedo.b = 1.25;
  CHECK(complaint(settings) == "a sky's ground albedo must be 0 to 1, not 1.25");
}

TEST_CASE("a sky says what it is") {
  CHECK(environment("iso-sky-5", withSun(10, 20.5, 1)).description() ==
        "builtin:iso-sky-5 (uniform; sun at azimuth 10°, elevation 20.5°, with its disc)");
}

}  // namespace haarlight::test
