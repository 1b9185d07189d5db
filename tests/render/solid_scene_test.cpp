#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "error_text.h"
#include "render/render_image.h"
#include "shading_by_transfer.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

const glm::dvec3 center(0.3, 1.4, -0.2);
constexpr double radius = 0.75;

ObjectDescription solidObject(const Shape& shape, const char* name) {
  ObjectDescription object;
  object.name = name;
  object.solid = shape;
  object.spheres = 8;
  return object;
}

/// A sphere that hovers over a plane.
SceneDescription sphereScene(const std::string& light = "builtin:constant") {
  SceneDescription scene;
  ObjectDescription sphere = solidObject(SphereShape{radius / 1.5}, "ball");
  sphere.transform.scale = glm::dvec3(1.5);
  sphere.transform.translate = center;
  scene.objects.push_back(sphere);
  scene.receiver = ReceiverDescription{};
  scene.receiver->samples = {16, 16};
  scene.light.source = light;
  scene.image.width = 96;
  scene.image.height = 64;
  scene.image.samplesPerPixel = 1;
  return scene;
}

/// Paints every sample with its position, and keeps all samples.
class SampleCollector final : public RadianceMethod {
 public:
  std::string name() const override { return "samples"; }
  std::string deviceName() const override { return "test"; }
  void sceneChanged(bool) override {}
  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    std::vector<glm::vec3> positions;
    for (const SurfaceSample& sample : samples) positions.push_back(sample.position);
    all.insert(all.end(), samples.begin(), samples.end());
    return positions;
  }

  std::vector<SurfaceSample> all;
};

/// Where a ray first meets the sphere; a negative number when it does not.
double sphereDistance(const glm::dvec3& origin, const glm::dvec3& direction) {
  const double along = glm::dot(center - origin, direction);
  const double across = glm::length(origin + along * direction - center);
  return across > radius ? -1 : along - std::sqrt(radius * radius - across * across);
}

MotionDescription motionTo(const MotionKey& end) {
  return {{MotionKey{}, end}, Repeat::hold};
}

std::unique_ptr<RadianceMethod> haarMethod(const Scene& scene,
                                           const std::vector<SurfaceSample>& samples) {
  return makeHaarMethod(scene, makeReferenceEngine(nullptr), {}, samples, false);
}

}  // namespace

TEST_CASE("a sphere's picture is its analytic disc, pixel by pixel, at its exact depth") {
  SceneDescription description = sphereScene();
  description.receiver.reset();
  const Scene scene = loadScene(description);
  const Camera camera(description.camera, 96, 64);
  SampleCollector method;
  const RenderedImage picture =
      ScreenSampler(scene, description.camera, description.image).render(method);
  int covered = 0;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 96; ++column) {
      const glm::dvec3 direction = camera.direction(column + 0.5, row + 0.5);
      const double distance = sphereDistance(camera.position(), direction);
      const bool hit = picture.surfaceMask[std::size_t(row) * 96 + column];
      REQUIRE(hit == (distance > 0));
      if (!hit) continue;
      ++covered;
      const glm::dvec3 expected = camera.position() + distance * direction;
      const double grazing = std::abs(glm::dot(direction, (expected - center) / radius));
      // In single precision a ray's direction is off by 6e-8, at the rim the hit by more.
      CHECK(glm::distance(glm::dvec3(picture.radiance.at(column, row)), expected) < 3e-6 / grazing);
      CHECK(glm::distance(glm::dvec3(picture.normal.at(column, row)),
                          (expected - center) / radius) < 4e-6 / grazing);
    }
  CHECK(covered > 150);
  for (const SurfaceSample& sample : method.all) {
    CHECK(sample.point.object == 0);
    CHECK(sample.normal == sample.geometricNormal);
    CHECK_FALSE(sample.point.fromBehind);
  }
}

TEST_CASE("solids hide each other, meshes and the receiver by depth") {
  SceneDescription description = sphereScene();
  description.objects.push_back(solidObject(BoxShape{{2, 0.05, 2}}, "board"));
  description.objects[1].transform.translate = {0, 0.3, 0};
  ObjectDescription mesh;
  mesh.mesh = "builtin:sphere";
  mesh.transform.translate = {0, -2, 0};
  mesh.spheres = 1;
  description.objects.push_back(mesh);
  const Scene scene = loadScene(description);
  SampleCollector method;
  ScreenSampler(scene, description.camera, description.image).render(method);
  int samplesOf[3] = {0, 0, 0}, onReceiver = 0;
  for (const SurfaceSample& sample : method.all)
    ++(sample.point.object == MeshPoint::onReceiver ? onReceiver : samplesOf[sample.point.object]);
  CHECK(samplesOf[0] > 100);
  CHECK(samplesOf[1] > 100);
  CHECK(samplesOf[2] == 0);  // beneath the plane
  CHECK(onReceiver > 100);
  for (const SurfaceSample& sample : method.all)
    if (sample.point.object == 1 && sample.normal.y > 0.5f)
      CHECK(sample.position.y == doctest::Approx(0.35).epsilon(1e-5));
}

TEST_CASE("a sphere blocks by itself alone, whatever number is asked for") {
  const Scene scene = loadScene(sphereScene());
  REQUIRE(scene.objects[0].spheres.size() == 1);
  CHECK(glm::distance(scene.objects[0].spheres[0].center, glm::vec3(center)) < 1e-6f);
  CHECK(scene.objects[0].spheres[0].radius == doctest::Approx(radius).epsilon(1e-6));
  SceneDescription clear = sphereScene();
  clear.objects[0].castsShadow = false;
  CHECK(loadScene(clear).blockerSpheres().empty());
  CHECK(loadScene(clear).occluders().empty());
}

TEST_CASE("other solids get spheres fitted to them") {
  SceneDescription description = sphereScene();
  description.objects[0].solid = ConeShape{0.5, 1, 0};
  const Scene scene = loadScene(description);
  const SceneObject& cone = scene.objects[0];
  CHECK(cone.spheres.size() == 8);
  CHECK(cone.measures.silhouette->mean < 0.2);
  for (const Sphere& sphere : cone.spheres) CHECK(cone.solid->contains(sphere.center));
}

TEST_CASE("the shadow of a sphere on a plane, by rays to the solid and by its closed form") {
  const SceneDescription description = sphereScene();
  const Scene scene = loadScene(description);
  const auto samples = planeSamples(*scene.receiver);
  const auto bySolid = makePixelMeshMethod(scene)->radiance(samples);
  CHECK(relativeError(bySolid, makePixelRayMethod(scene)->radiance(samples)) < 1e-3);
  CHECK(relativeError(bySolid, makePixelMethod(scene, nullptr)->radiance(samples)) < 1e-3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // A sphere above the horizon takes the part (r/d)² cos θ of the light.
    const glm::dvec3 way = center - glm::dvec3(samples[i].position);
    const double blocked = radius * radius / glm::dot(way, way) * glm::normalize(way).y;
    CHECK(bySolid[i].g == doctest::Approx(0.5 * (1 - blocked)).epsilon(0.01));
  }
}

TEST_CASE("the sphere follows a moving solid, and stands where its formula does") {
  SceneDescription description = sphereScene();
  MotionKey end;
  end.seconds = 2;
  end.translate = {1, 2, 3};
  end.rotation = {0, 1, 0, 1};
  end.scale = 3;
  description.objects[0].motion = motionTo(end);
  MovingScene scene(description);
  CHECK(scene.moves());
  scene.show(1);
  const SceneObject& ball = scene.scene().objects[0];
  const glm::dvec3 expected = center + glm::dvec3(0.5, 1, 1.5);
  CHECK(glm::distance(ball.solid->placement().translation(), expected) < 1e-14);
  CHECK(std::get<SphereShape>(ball.solid->shape()).radius == doctest::Approx(2 * radius));
  CHECK(glm::distance(glm::dvec3(ball.spheres[0].center), expected) < 1e-5);
  CHECK(ball.spheres[0].radius == doctest::Approx(2 * radius).epsilon(1e-5));
}

TEST_CASE("a solid turns about its pivot, and rests on the plane by its own lowest point") {
  SceneDescription description = sphereScene();
  description.receiver->center.y = 0.5;
  ObjectDescription cone = solidObject(ConeShape{1, 2, 0.25}, "cone");
  cone.transform.rotateDegrees = {30, 40, 50};
  cone.transform.scale = glm::dvec3(0.7);
  cone.transform.rest = Rest::Ground;
  cone.transform.translate = {2, 0, 1};
  MotionKey end;
  end.seconds = 1;
  end.rotation = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};  // +z to +x
  cone.motion = motionTo(end);
  description.objects = {cone};
  MovingScene scene(description);
  const Solid before = *scene.scene().objects[0].solid;
  CHECK(before.bounds().lower.y == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(std::get<ConeShape>(before.shape()).topRadius == 0.7 * 0.25);
  scene.show(1);
  const Solid after = *scene.scene().objects[0].solid;
  const glm::dvec3 pivot = before.placement().translation();
  CHECK(glm::distance(after.placement().translation(), pivot) < 1e-14);
  for (const glm::dvec3 direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), {1, 2, -3}}) {
    const glm::dvec3 turned(direction.z, direction.y, -direction.x);
    const glm::dvec3 point = before.support(direction) - pivot;
    CHECK(glm::distance(after.support(turned) - pivot, glm::dvec3(point.z, point.y, -point.x)) <
          1e-14);
  }
}

TEST_CASE("a solid's stand-in lies on it at every second") {
  SceneDescription description = sphereScene();
  description.objects = {solidObject(TorusShape{0.5, 0.2}, "ring")};
  description.objects[0].spheres = 4;
  description.objects[0].transform.rotateDegrees = {70, 0, 20};
  MotionKey end;
  end.seconds = 1;
  end.translate = {3, 1, 0};
  end.rotation = {1, 2, 3, 4};
  end.scale = 0.5;
  description.objects[0].motion = motionTo(end);
  MovingScene scene(description);
  for (const double second : {0.0, 0.5, 1.0}) {
    scene.show(second);
    const SceneObject& ring = scene.scene().objects[0];
    for (const SurfaceSample& sample : vertexSamples(scene.scene(), 0)) {
      const glm::dvec3 position(sample.position), out(sample.normal);
      CHECK(ring.solid->contains(position - 1e-5 * out));
      CHECK_FALSE(ring.solid->contains(position + 1e-5 * out));
    }
  }
}

TEST_CASE("objects have another revision when they are elsewhere") {
  SceneDescription description = sphereScene();
  description.objects.push_back(description.objects[0]);
  description.objects.push_back(description.objects[0]);
  MotionKey start, stop;
  start.seconds = 1;
  stop.seconds = 2;
  stop.translate = {1, 0, 0};
  description.objects[1].motion = MotionDescription{{start, stop}, Repeat::hold};
  stop.seconds = 5;
  description.objects[2].motion = motionTo(stop);
  MovingScene scene(description);
  const auto revisions = [&] {
    std::vector<std::uint64_t> result;
    for (const SceneObject& object : scene.scene().objects) result.push_back(object.revision);
    return result;
  };
  std::vector<std::uint64_t> before = revisions();
  const auto haveChanged = [&](bool first, bool second, bool third) {
    const std::vector<std::uint64_t> last = std::exchange(before, revisions());
    return (before[0] != last[0]) == first && (before[1] != last[1]) == second &&
           (before[2] != last[2]) == third;
  };
  scene.show(1);
  CHECK(haveChanged(false, false, true));
  scene.show(1.5);
  CHECK(haveChanged(false, true, true));
  scene.showMeshes(5);
  CHECK(haveChanged(false, true, true));
  scene.showMeshes(7);
  CHECK(haveChanged(false, false, false));
}

TEST_CASE("lights with hard shadows stand where their keys say") {
  SceneDescription description = sphereScene();
  PointLightDescription& lamp = description.pointLights.emplace_back();
  lamp.position = {1, 2, 3};
  lamp.intensity = {10, 20, 30};
  DirectionalLightDescription& sun = description.directionalLights.emplace_back();
  sun.towards = {0, 5, 0};
  sun.irradiance = {3, 2, 1};
  MovingScene still(description);
  CHECK_FALSE(still.moves());
  const std::vector<PunctualLight> expected{{PointLight{{1, 2, 3}}, {10, 20, 30}},
                                            {DirectionalLight{{0, 5, 0}}, {3, 2, 1}}};
  CHECK(still.scene().punctualLights == expected);
  still.show(3);
  CHECK(still.scene().punctualLights == expected);
  lamp.motion = {{{0, {}, Ease::linear}, {2, glm::dvec3(3, 2, 1), Ease::linear}}, Repeat::hold};
  CHECK(MovingScene(description).moves());
  lamp.motion.reset();
  sun.motion = {{{0, glm::dvec3(0, 1, 0), Ease::linear}, {2, glm::dvec3(1, 0, 0), Ease::linear}},
                Repeat::hold};
  MovingScene moving(description);
  CHECK(moving.moves());
  CHECK_FALSE(moving.showLight(1));  // the light all around stays
  CHECK(moving.scene().punctualLights[0] == expected[0]);
  const auto towards = std::get<DirectionalLight>(moving.scene().punctualLights[1].light).towards;
  CHECK(glm::distance(towards, glm::dvec3(std::sqrt(0.5), std::sqrt(0.5), 0)) < 1e-15);
}

TEST_CASE("families are handed on") {
  SceneDescription description = sphereScene();
  description.objects.push_back(description.objects[0]);
  description.objects[1].family = "fruit";
  const Scene scene = loadScene(description);
  CHECK(scene.objects[0].family.empty());
  CHECK(scene.objects[1].family == "fruit");
}

TEST_CASE("transfer is refused for solids") {
  const SceneDescription description = sphereScene();
  const std::string expected =
      "object 'ball' is a solid, and transfer is for the vertices of meshes: use --method haar or "
      "shexp, or a mesh";
  MovingScene scene(description);
  CHECK(inputErrorOf([&] { makeSceneTransfer(description, scene, {}, {}); }) == expected);
  CHECK(inputErrorOf([&] { wholeSceneMesh(scene.scene()); }) == expected);
}

TEST_CASE("a light that is turned off leaves all methods black") {
  SceneDescription description = sphereScene("builtin:lamps");
  description.light.scale = 0;
  const Scene scene = loadScene(description);
  CHECK(scene.light.projection.powerRatio == 1);
  const auto samples = planeSamples(*scene.receiver);
  const auto checkBlack = [&](RadianceMethod& method) {
    for (const glm::vec3& radiance : method.radiance(samples)) CHECK(radiance == glm::vec3(0));
  };
  checkBlack(*haarMethod(scene, samples));
  checkBlack(*makePixelMethod(scene, nullptr));
  checkBlack(*makePixelMeshMethod(scene));
  checkBlack(*makeShexpMethod(scene, makeReferenceEngine(nullptr), 4, samples, false));
}
