#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/ray_scene.h"
#include "render/moving_scene.h"
#include "render/render_image.h"
#include "scene/scene_file.h"

using namespace haarlight;

namespace {

/// The built-in scene with no more spheres than a picture's geometry needs.
SceneDescription describe(const char* name) {
  SceneDescription description = readScene(name);
  for (ObjectDescription& object : description.objects) object.spheres = 1;
  description.image.width /= 2;
  description.image.height /= 2;
  return description;
}

/// Points that face the light, in it or in the shadow of others.
struct Counts {
  int lit = 0, shadowed = 0;
};

/// Of a picture's overview: of objects, and at last of the receiver.
std::vector<Counts> countShadows(const SceneDescription& description) {
  const Scene scene = loadScene(description);
  const glm::dvec3 light = std::get<PointLight>(scene.punctualLights.at(0).light).position;
  std::vector<Counts> counts(scene.objects.size() + 1);
  const ScreenSampler sampler(scene, description.camera, description.image);
  for (const SurfaceSample& sample : sampler.overview()) {
    const std::size_t on = std::min<std::size_t>(sample.point.object, scene.objects.size());
    const glm::vec3 way = glm::vec3(light) - sample.position;
    if (glm::dot(way, sample.normal) < 0.05f * glm::length(way)) continue;
    std::vector<Occluder> others;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      if (i != on) others.push_back(scene.objects[i].occluder());
    const bool dark = RayScene(others).occluded(sample.position, way);
    ++(dark ? counts[on].shadowed : counts[on].lit);
  }
  return counts;
}

/// Whether what is in shadow on the receiver is seen whole: no sample at the picture's edge is.
bool shadowEndsInPicture(SceneDescription description) {
  const Scene scene = loadScene(description);
  const glm::vec3 light = std::get<PointLight>(scene.punctualLights.at(0).light).position;
  const RayScene rays(scene.occluders());
  const Camera camera(description.camera, description.image.width, description.image.height);
  const auto dark = [&](int x, int y) {
    const glm::dvec3 direction = camera.direction(x, y);
    const glm::vec3 point(camera.position() - camera.position().y / direction.y * direction);
    return direction.y < 0 && rays.occluded(point, light - point);
  };
  const int width = description.image.width, height = description.image.height;
  for (int x = 0; x <= width; ++x)
    if (dark(x, 0) || dark(x, height)) return false;
  for (int y = 0; y <= height; ++y)
    if (dark(0, y) || dark(width, y)) return false;
  return true;
}

}  // namespace

TEST_CASE("the lamp's knot has its shadow on the receiver, all of it in the picture") {
  const SceneDescription description = describe("builtin:lamp-knot");
  const std::vector<Counts> counts = countShadows(description);
  CHECK(counts.at(0).lit > 10);
  CHECK(counts.at(1).lit > 50);
  CHECK(counts.at(1).shadowed > 10);
  CHECK(shadowEndsInPicture(description));
}

TEST_CASE("the sphere's shadow falls on part of the cone, and both fall on the receiver") {
  const SceneDescription description = describe("builtin:cone-and-sphere");
  CHECK(description.objects.at(0).name == "cone");
  CHECK(description.objects.at(1).name == "sphere");
  const std::vector<Counts> counts = countShadows(description);
  CHECK(counts.at(0).lit > 4);
  CHECK(counts.at(0).shadowed > 4);
  CHECK(counts.at(1).lit > 4);
  CHECK(counts.at(1).shadowed == 0);
  CHECK(counts.at(2).lit > 50);
  CHECK(counts.at(2).shadowed > 10);
  CHECK(shadowEndsInPicture(description));
}
