#include "light/builtin_lights.h"

#include <numbers>

#include "cube/cube_map.h"
#include "image/color.h"
#include "light/analytic_environment.h"
#include "light/light_projection.h"
#include "light_test_support.h"

namespace haarlight::test {

namespace {

constexpr double pi = std::numbers::pi;

/// Irradiance of a surface with normal n, by the cube.
glm::dvec3 irradiance(const RadianceCube& cube, const glm::dvec3& n) {
  glm::dvec3 sum(0.0);
  for (int texel = 0; texel < texelCount; ++texel)
    sum += glm::dvec3(cube[texel]) * texelSolidAngle(texel) *
           std::max(0.0, glm::dot(n, texelDirection(texel)));
  return sum;
}

double floorLuminance(const std::string& name) {
  return luminance(irradiance(projectToCube(*makeBuiltinLight(name)).cube, {0, 1, 0}));
}

glm::vec3 towards(const Environment& light, double elevation, double azimuth) {
  const double e = elevation * pi / 180, a = azimuth * pi / 180;
  return light.radiance(
      glm::vec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)));
}

/// Share of the power's squares (energy) in the texels' difference to their neighbours: large for
/// a light with sharp edges.
double roughness(const RadianceCube& cube) {
  double differences = 0, squares = 0;
  for (int texel = 0; texel + 1 < texelCount; ++texel) {
    const double here = luminance(cube[texel]), next = luminance(cube[texel + 1]);
    squares += here * here;
    if ((texel + 1) % faceSize != 0) differences += (here - next) * (here - next);
  }
  return differences / squares;
}

}  // namespace

TEST_CASE("the power of gradients and lobes in closed form is that of their radiance") {
  const SkyGradient sky{{0.1, 0.2, 0.3}, {1, 2, 3}, {4, 5, 9}};
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
  const Lobe lobe{axis, std::cos(0.7), 1.5, {3, 2, 1}};
  const AnalyticEnvironment gradient("", sky, {});
  const AnalyticEnvironment both("", sky, {lobe});
  const LightProjection one = projectToCube(gradient), two = projectToCube(both);
  for (int c = 0; c < 3; ++c) {
    CHECK(one.sourcePower[c] == doctest::Approx(one.cubePower[c]).epsilon(1e-5));
    CHECK(two.sourcePower[c] == doctest::Approx(two.cubePower[c]).epsilon(1e-5));
    CHECK(irradiance(one.cube, {0, 1, 0})[c] ==
          doctest::Approx(sky.floorIrradiance()[c]).epsilon(1e-3));
    CHECK(irradiance(two.cube, {0, 1, 0})[c] - irradiance(one.cube, {0, 1, 0})[c] ==
          doctest::Approx(lobe.floorIrradiance()[c]).epsilon(1e-2));
  }
}

TEST_CASE("the constant light is 1 in every texel") {
  const auto light = makeBuiltinLight("builtin:constant");
  const LightProjection projection = projectToCube(*light);
  for (int texel = 0; texel < texelCount; ++texel)
    REQUIRE(projection.cube[texel] == glm::vec3(1.0f));
  CHECK(projection.powerRatio == doctest::Approx(1));
  CHECK(light->radiance(glm::vec3(0, -5, 2)) == glm::vec3(1.0f));
}

TEST_CASE("lamps, sky and constant light give a floor an irradiance of about pi") {
  for (const std::string name : {"builtin:lamps", "builtin:sky", "builtin:constant"}) {
    CAPTURE(name);
    CHECK(floorLuminance(name) == doctest::Approx(pi).epsilon(0.01));
  }
}

TEST_CASE("the cube keeps the power of the built-in lights in any rotation") {
  std::mt19937 random(1);
  for (const std::string name : {"builtin:lamps", "builtin:sky", "builtin:constant"})
    for (const glm::mat3& rotation : {glm::mat3(1.0f), randomRotation(random)}) {
      const LightProjection projection = projectToCube(*makeBuiltinLight(name), rotation);
      MESSAGE(name << ": cube power / source power = " << projection.powerRatio);
      CHECK(projection.powerRatio == doctest::Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("the lamps are bright spots above a dim sky and a darker ground") {
  const auto light = makeBuiltinLight("builtin:lamps");
  const glm::vec3 key = towards(*light, 42, 40);
  CHECK(luminance(key) > 500);
  CHECK(key.r > key.b);
  CHECK(towards(*light, 58, -100).b > towards(*light, 58, -100).r);
  CHECK(luminance(towards(*light, 42, 43)) < 0.2);
  const glm::vec3 zenith = light->radiance({0, 1, 0}), horizon = light->radiance({1, 0, 0}),
                  ground = light->radiance({0, -1, 0});
  CHECK(zenith.b > zenith.r);
  CHECK(luminance(zenith) > luminance(horizon));
  CHECK(luminance(horizon) > luminance(ground));
}

TEST_CASE("the sky is smooth where the lamps are sharp") {
  const RadianceCube sky = projectToCube(*makeBuiltinLight("builtin:sky")).cube;
  const RadianceCube lamps = projectToCube(*makeBuiltinLight("builtin:lamps")).cube;
  CHECK(roughness(sky) < 0.01);
  CHECK(roughness(lamps) > 0.5);
  // Half of the glow's height is more than 20° from its centre.
  const auto light = makeBuiltinLight("builtin:sky");
  CHECK(luminance(towards(*light, 75, 40)) > 0.5 * luminance(towards(*light, 55, 40)));
}

TEST_CASE("an unknown built-in light lists those there are") {
  const std::string error = inputErrorOf([] { makeBuiltinLight("builtin:moon"); });
  CHECK(error.starts_with(
      "there is no light \"builtin:moon\"; the built-in ones are builtin:lamps, builtin:sky, "
      "builtin:constant, builtin:cie-overcast, "));
  CHECK(error.ends_with(", builtin:iso-sky-15"));
}

}  // namespace haarlight::test
