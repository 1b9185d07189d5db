#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "base/file.h"
#include "image/compare.h"
#include "render/moving_scene.h"
#include "render/radiance_method.h"
#include "test_support.h"

using namespace haarlight;

namespace {

/// The bunny on a plane of 128×128 texels as `haarlight bake --mesh` has it.
SceneDescription bunnyScene(const std::string& mesh, const std::string& light) {
  SceneDescription scene;
  ObjectDescription object;
  object.name = "bunny";
  object.mesh = mesh;
  object.transform.fit = 2.0;
  object.transform.rest = Rest::Ground;
  scene.objects.push_back(object);
  scene.receiver = ReceiverDescription{};
  scene.light.source = light;
  return scene;
}

Image asImage(const std::vector<glm::vec3>& radiance) {
  Image image(int(radiance.size()), 1);
  image.pixels = radiance;
  return image;
}

std::shared_ptr<const SphereTable> sharedTable() {
  static const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  return table;
}

std::shared_ptr<const SphereTable> tableFor(VisibilityKind visibility) {
  return visibility == VisibilityKind::table ? sharedTable() : nullptr;
}

/// OpenCL where there is a device, else the reference engine: the bits are the same.
std::shared_ptr<Engine> anyEngine(VisibilityKind visibility) {
  return makeEngine({}, tableFor(visibility));
}

/// Root mean square error, relative to the mean, of the light cut to `terms` wavelets against the
/// sum over all texels with the same spheres, in percent.
double cutError(const Scene& scene, VisibilityKind visibility, int terms) {
  const auto samples = planeSamples(*scene.receiver);
  ShadingSettings settings;
  settings.terms = terms;
  const auto haar = makeHaarMethod(scene, anyEngine(visibility), settings, samples, false);
  const auto pixel = makePixelMethod(scene, tableFor(visibility));
  return 100 * compareImages(asImage(haar->radiance(samples)), asImage(pixel->radiance(samples)))
                   .relativeRootMeanSquare;
}

void checkCut(const std::string& light, double at200, double at100) {
  const auto mesh = test::testData("meshes/bunny.obj"), probe = test::testData("probes/" + light);
  if (!mesh || !probe) return;
  const Scene scene = loadScene(bunnyScene(mesh->string(), probe->string()));
  for (const VisibilityKind visibility : {VisibilityKind::exact, VisibilityKind::table}) {
    CHECK(cutError(scene, visibility, 200) <= at200);
    CHECK(cutError(scene, visibility, 100) <= at100);
  }
}

}  // namespace

TEST_CASE("plane under Grace Cathedral: at most 0.6 % error at 200 terms and 1 % at 100") {
  checkCut("grace.hdr", 0.6, 1.0);
}

TEST_CASE("plane under Uffizi: at most 0.2 % error at 200 terms and 1.5 % at 100") {
  checkCut("uffizi.hdr", 0.2, 1.5);
}

TEST_CASE("reference and OpenCL agree in every bit on the bunny scene") {
  const auto mesh = test::testData("meshes/bunny.obj"), probe = test::testData("probes/grace.hdr");
  if (!mesh || !probe) return;
  const auto devices = listDevices();
  if (devices.size() < 2) {
    std::printf("SKIPPED: %s\n", openClAdvice().c_str());
    return;
  }
  const Scene scene = loadScene(bunnyScene(mesh->string(), probe->string()));
  auto samples = vertexSamples(scene, 0);
  samples.resize(2000);
  ReceiverDescription coarse = *scene.receiver;
  coarse.samples = {48, 48};
  for (const SurfaceSample& sample : planeSamples(coarse)) samples.push_back(sample);
  for (const VisibilityKind visibility : {VisibilityKind::exact, VisibilityKind::table}) {
    std::vector<std::vector<glm::vec3>> radiance;
    for (const char* engine : {"reference", "opencl"}) {
      std::shared_ptr<Engine> made = makeEngine({.engine = engine}, tableFor(visibility));
      radiance.push_back(makeHaarMethod(scene, made, {}, samples, false)->radiance(samples));
    }
    CHECK(std::memcmp(radiance[0].data(), radiance[1].data(),
                      radiance[0].size() * sizeof(glm::vec3)) == 0);
  }
}

TEST_CASE("all terms with exact visibility give the pixel method's sum") {
  SceneDescription description = bunnyScene("builtin:torusknot", "builtin:lamps");
  description.objects[0].spheres = 24;
  description.receiver->samples = {12, 12};
  const Scene scene = loadScene(description);
  const auto samples = planeSamples(*scene.receiver);
  ShadingSettings settings;
  settings.terms = maximumTerms;
  const auto haar =
      makeHaarMethod(scene, anyEngine(VisibilityKind::exact), settings, samples, false)
          ->radiance(samples);
  const auto pixel = makePixelMethod(scene, nullptr)->radiance(samples);
  for (std::size_t i = 0; i < samples.size(); ++i)
    CHECK(haar[i].g == doctest::Approx(pixel[i].g).epsilon(1e-5));
}

TEST_CASE("a finely tessellated ball blocks as the sphere it approximates") {
  SceneDescription description = bunnyScene("builtin:sphere", "builtin:sky");
  description.objects[0].spheres = 1;
  description.objects[0].transform.translate = {0, 1, 0};
  description.receiver->samples = {16, 16};
  const Scene scene = loadScene(description);
  const auto samples = planeSamples(*scene.receiver);
  const ImageError error =
      compareImages(asImage(makePixelMethod(scene, nullptr)->radiance(samples)),
                    asImage(makePixelMeshMethod(scene)->radiance(samples)));
  // The enclosing sphere is larger than the icosphere by its chord error, under 1 % of the radius.
  CHECK(error.relativeRootMeanSquare < 0.005);
}

TEST_CASE("without blockers every method gives the unshadowed radiance") {
  SceneDescription description = bunnyScene("builtin:sphere", "builtin:sky");
  description.objects[0].castsShadow = false;
  description.receiver->samples = {4, 4};
  description.receiver->albedo = {0.25, 0.5, 1};
  const Scene scene = loadScene(description);
  const auto samples = planeSamples(*scene.receiver);
  const auto haar = makeHaarMethod(scene, anyEngine(VisibilityKind::exact), {}, samples, false)
                        ->radiance(samples);
  const auto pixel = makePixelMethod(scene, nullptr)->radiance(samples);
  const auto mesh = makePixelMeshMethod(scene)->radiance(samples);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      CHECK(pixel[i][channel] == mesh[i][channel]);
      CHECK(haar[i][channel] == doctest::Approx(pixel[i][channel]).epsilon(1e-5));
    }
}
