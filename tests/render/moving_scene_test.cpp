#include "render/moving_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/file.h"
#include "engine/devices.h"
#include "light/builtin_lights.h"
#include "render/radiance_method.h"
#include "render/surface_sample.h"
#include "scene/scene_file.h"

using namespace haarlight;

namespace {

SceneDescription twistScene() {
  SceneDescription scene = readScene("builtin:twist");
  scene.objects[0].spheres = 12;
  scene.receiver->samples = {24, 24};
  return scene;
}

/// A knot that stands still, over a plane, until it is given keys.
SceneDescription knotScene() {
  SceneDescription scene = twistScene();
  scene.objects[0].deformation.reset();
  scene.light.motion.reset();
  return scene;
}

/// Keys that take the object along `shift` in a second.
MotionDescription along(const glm::dvec3& shift) {
  MotionKey end;
  end.seconds = 1;
  end.translate = shift;
  return {{MotionKey{}, end}, Repeat::hold};
}

template <typename Element>
bool sameBits(const std::vector<Element>& a, const std::vector<Element>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

std::vector<glm::vec3> planeRadiance(const Scene& scene, const ReceiverDescription& plane,
                                     std::shared_ptr<Engine> engine) {
  const auto samples = planeSamples(plane);
  return makeHaarMethod(scene, std::move(engine), {}, samples, false)->radiance(samples);
}

std::vector<glm::vec3> exactPlaneRadiance(const Scene& scene, const ReceiverDescription& plane) {
  return planeRadiance(scene, plane, makeReferenceEngine(nullptr));
}

/// Mean absolute difference, relative to the mean of `a`.
double meanChange(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  double change = 0, mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      change += std::abs(double(a[i][channel]) - double(b[i][channel]));
      mean += a[i][channel];
    }
  return change / mean;
}

}  // namespace

TEST_CASE("what is shown at a second does not depend on what was shown before") {
  MovingScene forwards(twistScene()), backwards(twistScene());
  std::vector<Scene> seen;
  const double times[] = {0, 0.375, 1.25, 3.5};
  for (const double time : times) {
    forwards.show(time);
    seen.push_back(forwards.scene());
  }
  for (int i = 3; i >= 0; --i) {
    backwards.show(times[i]);
    const Scene& scene = backwards.scene();
    CHECK(sameBits(scene.objects[0].mesh.positions, seen[i].objects[0].mesh.positions));
    CHECK(sameBits(scene.objects[0].mesh.normals, seen[i].objects[0].mesh.normals));
    CHECK(sameBits(scene.blockerSpheres(), seen[i].blockerSpheres()));
    CHECK(sameBits(scene.light.projection.cube.texels, seen[i].light.projection.cube.texels));
  }
}

TEST_CASE("moving spheres in steps gives what show() gives") {
  MovingScene whole(twistScene()), steps(twistScene());
  whole.show(1.5);
  const auto engine = makeReferenceEngine(nullptr);
  engine->setSphereBinding(steps.binding());
  steps.showMeshes(1.5);
  steps.showSpheres(engine->moveSpheres(steps.boundVertices()));
  CHECK(steps.showLight(1.5));
  CHECK_FALSE(steps.showLight(1.5));
  CHECK(sameBits(whole.scene().blockerSpheres(), steps.scene().blockerSpheres()));
}

TEST_CASE("an object that stands still has the spheres of a scene without motion") {
  SceneDescription description = knotScene();
  description.objects.push_back(description.objects[0]);
  description.objects[1].motion = along({1, 0, 0});
  MovingScene scene(description);
  CHECK(scene.moves());
  scene.show(0.5);
  CHECK(sameBits(scene.scene().objects[0].spheres, loadScene(knotScene()).objects[0].spheres));
  for (std::size_t i = 0; i < 12; ++i) {
    const Sphere still = scene.scene().objects[0].spheres[i];
    const Sphere moved = scene.scene().objects[1].spheres[i];
    CHECK(glm::length(moved.center - still.center - glm::vec3(0.5f, 0, 0)) < 2e-6f);
    CHECK(std::abs(moved.radius - still.radius) < 1e-6f);
  }
  CHECK_FALSE(MovingScene(knotScene()).moves());
}

TEST_CASE("a scene moved as a whole keeps its radiance") {
  const SceneDescription still = knotScene();
  const auto before = exactPlaneRadiance(loadScene(still), *still.receiver);

  SceneDescription shifted = still;
  shifted.objects[0].motion = along({8, 4, -16});
  MovingScene scene(shifted);
  scene.show(1);
  ReceiverDescription plane = *still.receiver;
  plane.center += glm::dvec3(8, 4, -16);
  const auto after = exactPlaneRadiance(scene.scene(), plane);
  // Positions of 16 units are rounded to 2⁻²⁰; a texel at a sphere's rim may change sides.
  CHECK(meanChange(before, after) < 1e-4);

  // A quarter turn takes the cube's texels to texels.
  SceneDescription turned = still;
  MotionKey quarter;
  quarter.seconds = 1;
  quarter.rotation = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};
  turned.objects[0].motion = MotionDescription{{MotionKey{}, quarter}, Repeat::hold};
  LightKey lightQuarter;
  lightQuarter.seconds = 1;
  lightQuarter.rotateDegrees = 90;
  turned.light.motion = LightMotionDescription{{LightKey{}, lightQuarter}, Repeat::hold};
  MovingScene turning(turned);
  turning.show(1);
  const auto turnedRadiance = exactPlaneRadiance(turning.scene(), *still.receiver);
  const int side = still.receiver->samples.x;
  std::vector<glm::vec3> turnedBack;  // what stood at (x, z) is at (z, −x) now
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      turnedBack.push_back(turnedRadiance[std::size_t(side - 1 - column) * side + row]);
  CHECK(meanChange(before, turnedBack) < 1e-4);
}

TEST_CASE("a scene turned by an angle that is none of the cube's keeps its radiance roughly") {
  SceneDescription description = knotScene();
  description.receiver->samples = {48, 48};
  constexpr double degrees = 20;
  MotionKey turn;
  turn.seconds = 1;
  turn.rotation = {0, std::sin(glm::radians(degrees / 2)), 0, std::cos(glm::radians(degrees / 2))};
  description.objects[0].motion = MotionDescription{{MotionKey{}, turn}, Repeat::hold};
  LightKey lightTurn;
  lightTurn.seconds = 1;
  lightTurn.rotateDegrees = degrees;
  description.light.motion = LightMotionDescription{{LightKey{}, lightTurn}, Repeat::hold};
  auto samples = planeSamples(*description.receiver);
  const auto changeWith = [&](std::shared_ptr<const SphereTable> table) {
    MovingScene scene(description);
    const auto radianceNow = [&](const std::vector<SurfaceSample>& places) {
      return makeHaarMethod(scene.scene(), makeEngine({}, table), {}, places, false)
          ->radiance(places);
    };
    const auto before = radianceNow(samples);
    scene.show(1);
    auto turned = samples;
    for (SurfaceSample& sample : turned) sample.position = yawRotation(degrees) * sample.position;
    return meanChange(before, radianceNow(turned));
  };
  const double exact = changeWith(nullptr);
  const double table =
      changeWith(std::make_shared<const SphereTable>(SphereTable::load(cacheFolder())));
  MESSAGE("turned by 20 degrees: exact ", exact, ", table ", table);
  // The cube's 32 texels a side sample light and caps elsewhere: some thousandths of the mean.
  CHECK(exact < 0.005);
  CHECK(table < 0.005);
}

TEST_CASE("the change from frame to frame grows with the step") {
  SceneDescription description = knotScene();
  description.objects[0].motion = along({2, 0, 0});  // its own size in a second
  description.receiver->samples = {48, 48};
  // Mean change a step, over the same way.
  const auto meanChangeOf = [&](int steps, std::shared_ptr<const SphereTable> table) {
    MovingScene scene(description);
    const ReceiverDescription& plane = *description.receiver;
    double sum = 0;
    auto last = planeRadiance(scene.scene(), plane, makeEngine({}, table));
    for (int i = 1; i <= steps; ++i) {
      scene.show(0.032 * i / steps);
      auto next = planeRadiance(scene.scene(), plane, makeEngine({}, table));
      sum += meanChange(last, next) / steps;
      last = std::move(next);
    }
    return sum;
  };
  const double thousandth = meanChangeOf(32, nullptr), twice = meanChangeOf(16, nullptr),
               four = meanChangeOf(8, nullptr);
  MESSAGE("change for 0.001, 0.002, 0.004 of the size: ", thousandth, ", ", twice, ", ", four);
  // The table's bins make texels jump; there is no law to hold it to (docs/dynamic.md).
  const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  MESSAGE("the same with the table: ", meanChangeOf(32, table), ", ", meanChangeOf(16, table), ", ",
          meanChangeOf(8, table));
  CHECK(twice / thousandth > 1.7);
  CHECK(twice / thousandth < 2.3);
  CHECK(four / twice > 1.7);
  CHECK(four / twice < 2.3);
}

TEST_CASE("a sky follows its sun, and a sun without a sky is warned of") {
  SceneDescription description;
  description.receiver.emplace();
  description.light.source = "builtin:cie-clear";
  LightKey morning, noon;
  morning.sunElevationDegrees = 10;
  morning.sunAzimuthDegrees = 0;
  noon.seconds = 2;
  noon.sunElevationDegrees = 70;
  noon.sunAzimuthDegrees = 90;
  description.light.motion = LightMotionDescription{{morning, noon}, Repeat::hold};
  MovingScene scene(description);
  CHECK(scene.moves());
  CHECK(scene.scene().warnings.empty());
  CHECK(scene.showLight(1));
  CHECK_FALSE(scene.showLight(1));
  SkySettings between;
  between.sunElevationDegrees = 40;
  between.sunAzimuthDegrees = 45;
  const auto sky = makeBuiltinLight("builtin:cie-clear", between);
  CHECK(scene.scene().light.projection.cube.texels == projectToCube(*sky).cube.texels);
  CHECK(scene.scene().light.environment->description() == sky->description());
  description.light.source = "builtin:constant";
  const MovingScene constant(description);
  REQUIRE(constant.scene().warnings.size() == 1);
  CHECK(constant.scene().warnings[0] ==
        "the scene places a sun, but its light is no sky: builtin:constant");
}

TEST_CASE("lights cross-fade linearly") {
  SceneDescription description = knotScene();
  description.light = {};
  description.light.source = "builtin:lamps";
  LightKey first, second;
  second.seconds = 2;
  second.source = "builtin:sky";
  description.light.motion = LightMotionDescription{{first, second}, Repeat::hold};
  MovingScene scene(description);
  const RadianceCube from = scene.scene().light.projection.cube;
  scene.show(2);
  const RadianceCube to = scene.scene().light.projection.cube;
  scene.show(0.5);
  const SceneLight& light = scene.scene().light;
  for (int texel = 0; texel < texelCount; ++texel)
    REQUIRE(glm::length(light.projection.cube[texel] - (0.75f * from[texel] + 0.25f * to[texel])) <
            1e-5f * (1 + glm::length(from[texel])));
  CHECK(meanChange(from.texels, to.texels) > 0.1);
}
