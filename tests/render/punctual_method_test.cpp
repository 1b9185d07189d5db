#include "render/punctual_method.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/devices.h"
#include "render/moving_scene.h"
#include "render/surface_sample.h"

using namespace haarlight;

namespace {

using MakeMethod = std::function<std::unique_ptr<RadianceMethod>(const Scene&)>;

const glm::dvec3 center(0.3, 1.4, -0.2);
constexpr double radius = 0.75;
const LevelOfDetail detail{7, 0};
const glm::dvec3 lampPlace(-1.5, 4.5, 1), lampIntensity(10, 20, 30);
const glm::dvec3 sunDirection = glm::normalize(glm::dvec3(0.4, 1, 0.3)), sunIrradiance(3, 2, 1);

ObjectDescription solidAt(const Shape& shape, const glm::dvec3& place) {
  ObjectDescription object;
  object.solid = shape;
  object.transform.translate = place;
  object.albedo = {0.8, 0.5, 0.2};
  object.spheres = 4;
  return object;
}

void addLamp(SceneDescription& scene) {
  PointLightDescription& lamp = scene.pointLights.emplace_back();
  lamp.position = lampPlace;
  lamp.intensity = lampIntensity;
}

void addSun(SceneDescription& scene) {
  DirectionalLightDescription& sun = scene.directionalLights.emplace_back();
  sun.towards = 5.0 * sunDirection;
  sun.irradiance = sunIrradiance;
}

/// A ball that hovers over a plane, under the sky and without other lights.
SceneDescription ballScene() {
  SceneDescription scene;
  scene.objects = {solidAt(SphereShape{radius}, center)};
  scene.receiver = ReceiverDescription{};
  scene.receiver->samples = {40, 40};
  scene.light.source = "builtin:sky";
  return scene;
}

/// Solids and a mesh that shadow each other and the plane.
SceneDescription crowdedScene() {
  SceneDescription scene = ballScene();
  scene.receiver->samples = {400, 400};
  scene.objects.push_back(solidAt(TorusShape{0.7, 0.2}, {-0.4, 2.6, 0.3}));
  scene.objects.push_back(solidAt(BoxShape{{0.3, 0.5, 0.4}}, {1.8, 0.5, -0.6}));
  ObjectDescription knot;
  knot.mesh = "builtin:torusknot";
  knot.transform.fit = 1.6;
  knot.transform.translate = {-1.5, 0.9, -1.2};
  knot.spheres = 4;
  scene.objects.push_back(knot);
  return scene;
}

/// Knows of no light, so that punctual lights' is all there is.
class DarkMethod final : public RadianceMethod {
 public:
  std::string name() const override { return "dark"; }
  std::string deviceName() const override { return "test"; }
  void sceneChanged(bool) override {}
  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    return std::vector<glm::vec3>(samples.size(), glm::vec3(0));
  }
};

std::unique_ptr<RadianceMethod> byOctrees(const Scene& scene, const LevelOfDetail& level) {
  return withPunctualLights(std::make_unique<DarkMethod>(), scene, level);
}

std::unique_ptr<RadianceMethod> byRays(const Scene& scene) {
  return withExactPunctualLights(std::make_unique<DarkMethod>(), scene);
}

std::unique_ptr<RadianceMethod> pixelMethod(const Scene& scene) {
  return makePixelMethod(scene, nullptr);
}

std::unique_ptr<RadianceMethod> haarMethod(const Scene& scene) {
  ShadingSettings settings;
  settings.terms = 50;
  return makeHaarMethod(scene, makeReferenceEngine(nullptr), settings,
                        planeSamples(*scene.receiver), true);
}

/// Those of the plane and of the first object's vertices.
std::vector<SurfaceSample> samplesOf(const Scene& scene) {
  std::vector<SurfaceSample> samples = planeSamples(*scene.receiver);
  const auto ofObject = vertexSamples(scene, 0);
  samples.insert(samples.end(), ofObject.begin(), ofObject.end());
  return samples;
}

/// What a light brings to a surface, and how far (in lengths across its rays, or of the cosine
/// on the ball) the point is from the edge of a shadow.
struct Expected {
  glm::dvec3 irradiance;
  double fromEdge;
};

/// `towards`: unit, to the light; `strength`: irradiance on what faces it.
Expected underBall(const SurfaceSample& sample, const glm::dvec3& towards,
                   const glm::dvec3& strength) {
  const double cosine = glm::dot(glm::dvec3(sample.normal), towards);
  if (sample.point.object == 0) return {std::max(cosine, 0.) * strength, std::abs(cosine)};
  const glm::dvec3 way = center - glm::dvec3(sample.position);
  const double across = glm::length(way - glm::dot(way, towards) * towards);
  return {across > radius ? cosine * strength : glm::dvec3(0), std::abs(across - radius)};
}

Expected ofLamp(const SurfaceSample& sample) {
  const glm::dvec3 way = lampPlace - glm::dvec3(sample.position);
  return underBall(sample, glm::normalize(way), lampIntensity / glm::dot(way, way));
}

Expected ofSun(const SurfaceSample& sample) {
  return underBall(sample, sunDirection, sunIrradiance);
}

/// Checks every sample that is further than `margin` from the edges of shadows.
void checkSum(const std::vector<SurfaceSample>& samples, const std::vector<glm::vec3>& without,
              const std::vector<glm::vec3>& with, double margin) {
  REQUIRE(with.size() == samples.size());
  int lit[2] = {0, 0}, dark[2] = {0, 0}, wrong = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Expected lights[] = {ofLamp(samples[i]), ofSun(samples[i])};
    if (lights[0].fromEdge < margin || lights[1].fromEdge < margin) continue;
    const bool onBall = samples[i].point.object == 0;
    for (const Expected& light : lights) ++(light.irradiance.x > 0 ? lit : dark)[onBall];
    const glm::dvec3 expected =
        glm::dvec3(without[i]) + glm::dvec3(samples[i].albedo) / std::numbers::pi *
                                     (lights[0].irradiance + lights[1].irradiance);
    wrong += glm::distance(glm::dvec3(with[i]), expected) > 2e-6 * glm::length(expected);
  }
  CHECK(wrong == 0);
  for (const bool onBall : {false, true}) {
    CHECK(lit[onBall] > 100);
    CHECK(dark[onBall] > 100);
  }
}

/// Samples whose radiance differs by more than rounding, as a part of all.
double wrongPart(const std::vector<glm::vec3>& radiance, const std::vector<glm::vec3>& reference) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i)
    wrong += glm::distance(radiance[i], reference[i]) > 1e-5f * glm::length(reference[i]);
  return double(wrong) / double(radiance.size());
}

MotionDescription motionBy(const glm::dvec3& shift) {
  MotionKey end;
  end.seconds = 1;
  end.translate = shift;
  return {{MotionKey{}, end}, Repeat::hold};
}

/// Shows a second and returns how many octrees it took.
std::size_t octreesBuiltFor(double second, MovingScene& scene, RadianceMethod& method) {
  const std::size_t before = method.builtShadowOctrees();
  scene.showMeshes(second);
  method.sceneChanged(scene.showLight(second, method.readsLightCube()));
  return method.builtShadowOctrees() - before;
}

/// Checks that a method that has followed the scene computes what a fresh one does.
void checkLikeFresh(RadianceMethod& method, const Scene& scene) {
  const auto samples = samplesOf(scene);
  CHECK(method.radiance(samples) == byOctrees(scene, detail)->radiance(samples));
}

}  // namespace

TEST_CASE("punctual lights add to any method what they bring to a surface that sees them") {
  const Scene plain = loadScene(ballScene());
  SceneDescription description = ballScene();
  addLamp(description);
  addSun(description);
  const Scene scene = loadScene(description);
  const auto samples = samplesOf(scene);
  const double cell = std::sqrt(3.) * scene.receiver->size.x / 1024;
  for (const MakeMethod& make : {MakeMethod(pixelMethod), MakeMethod(haarMethod)}) {
    const auto without = make(plain)->radiance(samples);
    const auto method = withPunctualLights(make(scene), scene, {10, 0});
    CAPTURE(method->name());
    CHECK(method->builtShadowOctrees() == 4);
    checkSum(samples, without, method->radiance(samples), cell);
    const auto exact = withExactPunctualLights(make(scene), scene);
    CHECK(exact->name() == method->name());
    CHECK(exact->builtShadowOctrees() == 0);
    checkSum(samples, without, exact->radiance(samples), 1e-5);
  }
}

TEST_CASE("a scene without punctual lights leaves a method as it is") {
  const Scene scene = loadScene(ballScene());
  auto method = pixelMethod(scene);
  const RadianceMethod* const before = method.get();
  method = withPunctualLights(std::move(method), scene, {8, 0});
  CHECK(method.get() == before);
  method = withExactPunctualLights(std::move(method), scene);
  CHECK(method.get() == before);
}

TEST_CASE("a light without intensity changes nothing") {
  SceneDescription description = ballScene();
  addLamp(description);
  description.pointLights[0].intensity = glm::dvec3(0);
  const Scene scene = loadScene(description);
  const auto samples = samplesOf(scene);
  for (const glm::vec3& radiance : byOctrees(scene, detail)->radiance(samples))
    CHECK(radiance == glm::vec3(0));
}

TEST_CASE("the inside of a solid is dark, be light outside or within") {
  for (const glm::dvec3& place : {lampPlace, center}) {
    SceneDescription description = ballScene();
    addLamp(description);
    description.pointLights[0].position = place;
    const Scene scene = loadScene(description);
    auto samples = vertexSamples(scene, 0);
    for (SurfaceSample& sample : samples) {
      sample.point.fromBehind = true;
      sample.normal = sample.geometricNormal = -sample.normal;
    }
    const std::vector<glm::vec3> dark(samples.size(), glm::vec3(0));
    CHECK(byOctrees(scene, detail)->radiance(samples) == dark);
    CHECK(byRays(scene)->radiance(samples) == dark);
  }
}

TEST_CASE("the finer the octrees, the fewer samples differ from rays to the light") {
  for (const auto& add : {addLamp, addSun}) {
    SceneDescription description = crowdedScene();
    add(description);
    const Scene scene = loadScene(description);
    const auto samples = planeSamples(*scene.receiver);
    const auto exact = byRays(scene)->radiance(samples);
    const auto errorAt = [&](const LevelOfDetail& level) {
      return wrongPart(byOctrees(scene, level)->radiance(samples), exact);
    };
    double last = errorAt({4, 0});
    CHECK(last > 0.005);
    for (const int finer : {6, 8, 10}) {
      const double error = errorAt({finer, 0});
      CAPTURE(finer);
      CAPTURE(error);
      CHECK(error < last / 2);
      last = error;
    }
    CHECK(last < 0.002);
    CHECK(errorAt({0.01, 0}) == last);
  }
}

TEST_CASE("of a scene that moves only those octrees are built anew that can differ") {
  SceneDescription description = ballScene();
  addLamp(description);
  addSun(description);
  description.objects.push_back(solidAt(ConeShape{0.3, 0.6}, {3, 0.3, 3}));
  description.objects.push_back(solidAt(BoxShape{glm::dvec3(0.2)}, {-3, 0.2, 3}));
  description.objects[0].motion = motionBy({0.5, 0.3, -0.4});
  MovingScene scene(description);
  const auto method = byOctrees(scene.scene(), detail);
  CHECK(method->builtShadowOctrees() == 2 * 4);
  CHECK(octreesBuiltFor(0, scene, *method) == 0);
  const auto before = method->radiance(samplesOf(scene.scene()));
  CHECK(octreesBuiltFor(0.5, scene, *method) == 2 * 2);  // the ball and the plane
  checkLikeFresh(*method, scene.scene());
  CHECK(octreesBuiltFor(1, scene, *method) == 2 * 2);
  checkLikeFresh(*method, scene.scene());
  CHECK(octreesBuiltFor(2, scene, *method) == 0);
  CHECK(octreesBuiltFor(0, scene, *method) == 2 * 2);
  CHECK(method->radiance(samplesOf(scene.scene())) == before);
}

TEST_CASE("all octrees of a light that moves are built anew, and of no other") {
  SceneDescription description = ballScene();
  addLamp(description);
  addSun(description);
  description.pointLights[0].motion = {
      {{0, {}, Ease::linear}, {1, glm::dvec3(2, 5, -1), Ease::linear}}, Repeat::hold};
  MovingScene scene(description);
  const auto method = byOctrees(scene.scene(), detail);
  const auto exact = byRays(scene.scene());
  for (const double second : {0.5, 1.}) {
    CHECK(octreesBuiltFor(second, scene, *method) == 2);
    checkLikeFresh(*method, scene.scene());
    exact->sceneChanged(false);
    const auto samples = planeSamples(*scene.scene().receiver);
    CHECK(wrongPart(method->radiance(samples), exact->radiance(samples)) < 0.01);
  }
  CHECK(octreesBuiltFor(3, scene, *method) == 0);
}

TEST_CASE("octrees follow a mesh that bends") {
  SceneDescription description = crowdedScene();
  description.receiver->samples = {40, 40};
  addLamp(description);
  BendDescription bend;
  bend.keys = {{0, 0, Ease::linear}, {1, 120, Ease::linear}};
  description.objects[3].deformation.emplace().bend = bend;
  MovingScene scene(description);
  const auto method = byOctrees(scene.scene(), detail);
  const auto samples = planeSamples(*scene.scene().receiver);
  const auto before = method->radiance(samples);
  const std::size_t built = octreesBuiltFor(1, scene, *method);
  CHECK(built >= 2);  // the knot and the plane
  CHECK(built < scene.scene().objects.size() + 1);
  CHECK(wrongPart(method->radiance(samples), before) > 0.01);
  checkLikeFresh(*method, scene.scene());
}
