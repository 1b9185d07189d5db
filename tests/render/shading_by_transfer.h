#pragma once

/// A scene for the method sh, and what it makes of one.

#include <doctest/doctest.h>

#include "engine/devices.h"
#include "image/compare.h"
#include "render/radiance_method.h"

namespace haarlight::test {

/// A ball that hovers over a plane, or whatever `mesh` is.
inline SceneDescription ballScene(const std::string& light = "builtin:sky",
                                  const std::string& mesh = "builtin:sphere") {
  SceneDescription scene;
  ObjectDescription object;
  object.name = "ball";
  object.mesh = mesh;
  object.transform.fit = 1.0;
  object.transform.translate = {0.2, 0.9, -0.1};
  object.albedo = {0.8, 0.4, 0.2};
  object.spheres = 1;
  scene.objects.push_back(object);
  scene.receiver = ReceiverDescription{};
  scene.receiver->size = {4, 3};
  scene.receiver->samples = {24, 18};
  scene.light.source = light;
  return scene;
}

/// What `sh` makes of a scene, on the scalar engine.
struct Shading {
  explicit Shading(const SceneDescription& description, ShadedPer per = ShadedPer::vertex,
                   const std::vector<std::filesystem::path>& files = {})
      : moving(description),
        transfer(std::make_shared<const SceneTransfer>(
            makeSceneTransfer(description, moving, files, description.shading.order))),
        method(makeTransferMethod(moving.scene(), makeReferenceEngine(nullptr), transfer, per)) {}

  const Scene& scene() const { return moving.scene(); }
  std::vector<glm::vec3> ofPlane() {
    return method->radiance(planeSamples(*moving.scene().receiver));
  }
  std::vector<glm::vec3> ofObject(std::size_t object = 0) {
    return method->radiance(vertexSamples(moving.scene(), object));
  }

  MovingScene moving;
  std::shared_ptr<const SceneTransfer> transfer;
  std::unique_ptr<RadianceMethod> method;
};

inline Image asImage(const std::vector<glm::vec3>& radiance) {
  Image image(int(radiance.size()), 1);
  image.pixels = radiance;
  return image;
}

inline double relativeError(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  return compareImages(asImage(a), asImage(b)).relativeRootMeanSquare;
}

inline void checkColor(const glm::vec3& color, const glm::vec3& expected, double epsilon) {
  for (int c = 0; c < 3; ++c) CHECK(color[c] == doctest::Approx(expected[c]).epsilon(epsilon));
}

}  // namespace haarlight::test
