#include "render/light_coefficients.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "light/builtin_lights.h"
#include "sh/cube_basis.h"
#include "shading_by_transfer.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("a light that is turned is its coefficients turned") {
  constexpr int order = 5;
  LightCoefficients coefficients(order);
  SceneLight light{makeBuiltinLight("builtin:sky"), yawRotation(0), 1, {}, {}};
  for (const double degrees : {0.0, 40.0, -130.0}) {
    light.rotation = yawRotation(degrees);
    light.scale = 2;
    const TransferLights turned = coefficients.of(light);
    REQUIRE(turned.count() == 1);
    const ShVector<glm::vec3> again =
        projectToSh(order, projectToCube(*light.environment, light.rotation, light.scale).cube);
    const double largest = glm::length(again[0]);
    for (int channel = 0; channel < 3; ++channel)
      for (int k = 0; k < order * order; ++k)
        CHECK(std::abs(turned.light(0, channel)[k] - again[k][channel]) < 2e-3 * largest);
  }
}

TEST_CASE("the cube is left alone until somebody reads it") {
  SceneDescription description = ballScene();
  auto& keys = description.light.motion.emplace().keys;
  keys.resize(2);
  keys[1].seconds = 1;
  keys[1].scale = 2;
  MovingScene moving(description);
  const SceneLight& light = moving.scene().light;
  const glm::vec3 first = light.projection.cube[0];
  REQUIRE(first.x > 0);
  CHECK(moving.showLight(1, false));
  CHECK(light.scale == 2);
  CHECK(light.projection.cube[0] == first);
  CHECK_FALSE(moving.showLight(1, false));
  CHECK(moving.showLight(1));
  CHECK(light.projection.cube[0] == 2.0f * first);
  CHECK_FALSE(moving.showLight(1));
  CHECK_FALSE(moving.showLight(1, false));
}

TEST_CASE("when the light turns, so does what sh shows") {
  SceneDescription description = ballScene();
  auto& keys = description.light.motion.emplace().keys;
  keys.resize(2);
  keys[1].seconds = 1;
  keys[1].rotateDegrees = 90;
  Shading moving(description);
  const auto before = moving.ofPlane();
  CHECK_FALSE(moving.method->readsLightCube());
  moving.moving.showLight(1, false);
  moving.method->sceneChanged(true);
  const auto after = moving.ofPlane();
  SceneDescription turned = ballScene();
  turned.light.rotateDegrees = 90;
  CHECK(relativeError(after, before) > 0.02);
  CHECK(relativeError(after, Shading(turned).ofPlane()) < 1e-6);
}

TEST_CASE("near light goes from one sample to another by the inverse square of the distance") {
  SceneDescription description = ballScene("builtin:sky");
  description.objects.clear();
  const auto addSample = [&](const glm::dvec3& position, double scale) {
    LightSampleDescription& sample = description.light.samples.emplace_back();
    sample.position = position;
    sample.source = "builtin:constant";
    sample.scale = scale;
  };
  addSample({-2, 0, 0}, 1);
  addSample({1, 0, 0}, 4);
  Shading vertex(description), pixel(description, ShadedPer::pixel);
  const auto samples = planeSamples(*description.receiver);
  const auto shaded = pixel.ofPlane();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const glm::dvec3 p(samples[i].position);
    const double first = 1 / glm::dot(p - glm::dvec3(-2, 0, 0), p - glm::dvec3(-2, 0, 0));
    const double second = 1 / glm::dot(p - glm::dvec3(1, 0, 0), p - glm::dvec3(1, 0, 0));
    checkColor(shaded[i], glm::vec3(0.5 * (first + 4 * second) / (first + second)), 1e-4);
  }
  CHECK(relativeError(vertex.ofPlane(), shaded) < 0.01);
}

TEST_CASE("at the place of a light sample it shines alone") {
  SceneLight light;
  light.samples.resize(3);
  light.samples[1].position = {1, 2, 3};
  light.samples[2].position = {4, 0, 0};
  std::vector<float> weights(3);
  weighLights(light, {1, 2, 3}, weights);
  CHECK(weights == std::vector<float>{0, 1, 0});
  weighLights(light, {2, 0, 0}, weights);
  CHECK(weights[0] == weights[2]);
  CHECK(weights[0] + weights[1] + weights[2] == doctest::Approx(1).epsilon(1e-6));
  light.samples.clear();
  weighLights(light, {2, 0, 0}, std::span(weights).first(1));
  CHECK(weights[0] == 1);
}
