#include "render/scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "render/moving_scene.h"
#include "scene/scene_file.h"
#include "spheres/sphere_set.h"
#include "test_support.h"

using namespace haarlight;

namespace {

SceneDescription sphereScene() {
  SceneDescription scene;
  ObjectDescription object;
  object.name = "ball";
  object.mesh = "builtin:sphere";
  object.spheres = 1;
  scene.objects.push_back(object);
  scene.light.source = "builtin:constant";
  return scene;
}

}  // namespace

TEST_CASE("meshes and spheres are moved into the world together") {
  SceneDescription description = sphereScene();
  description.objects[0].objective = FitObjective::cover;
  TransformDescription& transform = description.objects[0].transform;
  transform.scale = {2, 2, 2};
  transform.rotateDegrees = {10, 20, 30};
  transform.translate = {1, -2, 3};
  const Scene scene = loadScene(description);
  REQUIRE(scene.objects[0].spheres.size() == 1);
  const Sphere sphere = scene.objects[0].spheres[0];
  CHECK(glm::length(sphere.center - glm::vec3(1, -2, 3)) < 1e-3f);
  CHECK(sphere.radius == doctest::Approx(2).epsilon(2e-3));
  for (const glm::vec3& position : scene.objects[0].mesh.positions)
    REQUIRE(glm::length(position - sphere.center) <= sphere.radius * (1 + 1e-6f));
}

TEST_CASE("spheres still cover a mesh that is stretched unevenly") {
  SceneDescription description = sphereScene();
  description.objects[0].spheres = 12;
  description.objects[0].objective = FitObjective::cover;
  description.objects[0].transform.scale = {1, 3, 0.5};
  const Scene scene = loadScene(description);
  for (const glm::vec3& position : scene.objects[0].mesh.positions) {
    bool covered = false;
    for (const Sphere& sphere : scene.objects[0].spheres)
      covered |= glm::length(position - sphere.center) <= sphere.radius * (1 + 1e-5f);
    REQUIRE(covered);
  }
}

TEST_CASE("an object can rest on the plane, see and be seen, and cast no shadow") {
  SceneDescription description = sphereScene();
  description.receiver = ReceiverDescription{};
  description.receiver->center = {0, 1.5, 0};
  description.objects[0].transform.rest = Rest::Ground;
  description.objects[0].castsShadow = false;
  const Scene scene = loadScene(description);
  CHECK(boundingBox(scene.objects[0].mesh).lower.y == doctest::Approx(1.5));
  CHECK(scene.blockerSpheres().empty());
}

TEST_CASE("the light is scaled and turned") {
  SceneDescription description = sphereScene();
  description.light.scale = 2.5;
  for (const glm::vec3& texel : loadScene(description).light.projection.cube.texels)
    REQUIRE(texel.g == doctest::Approx(2.5).epsilon(1e-5));

  description.light.source = "builtin:lamps";
  description.light.scale = 1;
  const Scene straight = loadScene(description);
  description.light.rotateDegrees = 90;
  const Scene turned = loadScene(description);
  const glm::vec3 direction = glm::normalize(glm::vec3(0.3f, 0.4f, 0.8f));
  // A turn by 90° from +Z towards +X takes (x, y, z) to (z, y, −x).
  const glm::vec3 image(direction.z, direction.y, -direction.x);
  CHECK(glm::length(turned.light.radiance(image) - straight.light.radiance(direction)) < 1e-5f);
}

TEST_CASE("a fitted set is found again in the cache and a file's set is used as it is") {
  const test::TemporaryFolder folder;
  SphereSet set;
  set.spheres = {{{0, 0, 0}, 1.25f}};
  set.meshName = "builtin:sphere";
  set.meshHash = meshHash(builtinMesh("builtin:sphere"));
  set.method = "by hand";
  writeSphereSet(folder / "set.json", set);
  SceneDescription description = sphereScene();
  description.objects[0].spheres = folder / "set.json";
  const Scene scene = loadScene(description);
  CHECK(scene.objects[0].spheres[0].radius == 1.25f);
  CHECK(scene.warnings.empty());

  description.objects[0].mesh = "builtin:torusknot";
  CHECK(loadScene(description).warnings.size() == 1);  // made for another mesh

  SceneDescription fitted = sphereScene();
  fitted.objects[0].spheres = 5;
  const auto first = loadScene(fitted).blockerSpheres(),
             second = loadScene(fitted).blockerSpheres();
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].radius == second[i].radius);
}

TEST_CASE("missing files are named") {
  SceneDescription description = sphereScene();
  description.objects[0].mesh = "/no/such/mesh.obj";
  CHECK_THROWS_AS(loadScene(description), InputError);
  description = sphereScene();
  description.light.source = "/no/such/light.hdr";
  CHECK_THROWS_AS(loadScene(description), InputError);
}
