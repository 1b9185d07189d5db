#include "render/render_image.h"

#include <doctest/doctest.h>

#include "render/moving_scene.h"

using namespace haarlight;

namespace {

/// Paints every sample with its position, so that pictures show geometry.
class PositionMethod final : public RadianceMethod {
 public:
  std::string name() const override { return "position"; }
  void sceneChanged(bool) override {}
  std::string deviceName() const override { return "test"; }
  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    std::vector<glm::vec3> positions;
    for (const SurfaceSample& sample : samples) positions.push_back(sample.position);
    return positions;
  }
};

SceneDescription planeFromAbove() {
  SceneDescription scene;
  scene.receiver = ReceiverDescription{};
  scene.receiver->size = {2, 2};
  scene.light.source = "builtin:constant";
  scene.camera.position = {0, 1, 0};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  scene.camera.verticalFieldOfViewDegrees = 90;  // sees z from −1 to 1 at the plane
  scene.image.width = 40;
  scene.image.height = 20;
  scene.image.samplesPerPixel = 4;
  return scene;
}

}  // namespace

TEST_CASE("seen from above, columns run along x and rows along z") {
  const SceneDescription description = planeFromAbove();
  const Scene scene = loadScene(description);
  PositionMethod method;
  const RenderedImage picture =
      ScreenSampler(scene, description.camera, description.image).render(method);
  for (int row = 0; row < 20; ++row)
    for (int column = 11; column < 29; ++column) {
      const glm::vec3 position = picture.radiance.at(column, row);
      CHECK(position.x == doctest::Approx((column - 19.5) / 10).epsilon(1e-5));
      CHECK(position.z == doctest::Approx((row - 9.5) / 10).epsilon(1e-5));
    }
}

TEST_CASE("beside the plane the background shows and the mask is 0") {
  SceneDescription description = planeFromAbove();
  PositionMethod method;
  const Scene scene = loadScene(description);
  const RenderedImage lit =
      ScreenSampler(scene, description.camera, description.image).render(method);
  CHECK(lit.radiance.at(0, 10) == glm::vec3(1));
  CHECK(lit.surfaceMask[10 * 40] == 0);
  CHECK(lit.surfaceMask[10 * 40 + 20] == 1);
  CHECK(lit.albedo.at(0, 10) == glm::vec3(0));
  CHECK(lit.normal.at(20, 10) == glm::vec3(0, 1, 0));
  CHECK(lit.surfaceSamples == 20 * 20 * 4);
  description.image.background = glm::dvec3(0.25, 0.5, 0.75);
  const RenderedImage plain =
      ScreenSampler(scene, description.camera, description.image).render(method);
  CHECK(plain.radiance.at(0, 10) == glm::vec3(0.25f, 0.5f, 0.75f));
}

TEST_CASE("surfaces seen from behind turn their normals to the viewer") {
  SceneDescription description = planeFromAbove();
  description.camera.position = {0, -1, 0};
  PositionMethod method;
  const Scene scene = loadScene(description);
  const RenderedImage picture =
      ScreenSampler(scene, description.camera, description.image).render(method);
  CHECK(picture.normal.at(20, 10) == glm::vec3(0, -1, 0));
}
