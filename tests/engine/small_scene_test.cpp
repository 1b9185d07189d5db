#include <doctest/doctest.h>

#include <cstring>

#include "test_scenes.h"
#include "test_transfer.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Three receivers, so that a group of four is not full, and more spheres than there are lanes.
TestScene smallScene() {
  TestScene scene = randomScene(1, 3);
  while (scene.spheres.size() < 34) scene.spheres.push_back(scene.spheres.back());
  scene.spheres.resize(34);
  return scene;
}

/// Six spheres, so that a second group of four is not full; lists of more than 32 entries.
void checkMovedSpheres(Engine& engine) {
  const auto [binding, vertices] = randomBinding(2, 6);
  REQUIRE(binding.vertices.size() > 6 * 32);
  engine.setSphereBinding(binding);
  const auto expected = moveSpheres(binding, vertices), moved = engine.moveSpheres(vertices);
  REQUIRE(moved.size() == expected.size());
  CHECK(std::memcmp(moved.data(), expected.data(), expected.size() * sizeof expected[0]) == 0);
}

void checkExponentiation(Engine& engine, const TestScene& scene) {
  const auto tables = buildExponentiationTables(scene.light, 5, countLobes(scene.receivers.lobes));
  const auto reference = referenceEngine();
  reference->setExponentiation(tables);
  engine.setExponentiation(tables);
  const auto expected = reference->shadeByExponentiation(scene.spheres, scene.receivers);
  const auto radiance = engine.shadeByExponentiation(scene.spheres, scene.receivers);
  REQUIRE(radiance.size() == expected.size());
  CHECK(std::memcmp(radiance.data(), expected.data(), expected.size() * sizeof expected[0]) == 0);
}

/// With rows of one float4 a channel, and with more coefficients than lanes.
void checkTransfer(Engine& engine) {
  const auto reference = referenceEngine();
  for (const int order : {2, 6}) {
    const TestTransfer transfer = randomTransfer(1, order, 3, 34, 2, true);
    for (Engine* each : {reference.get(), &engine}) {
      each->setTransferRows(transfer.rows);
      each->setTransferLights(transfer.lights);
    }
    const auto expected = reference->shadeByTransfer(transfer.receivers),
               shaded = engine.shadeByTransfer(transfer.receivers);
    REQUIRE(shaded.size() == expected.size());
    CHECK(std::memcmp(shaded.data(), expected.data(), expected.size() * sizeof expected[0]) == 0);
  }
}

void checkEveryKernel(VisibilityKind visibility, const KernelShape& shape) {
  EngineOptions options;
  options.engine = "opencl";
  options.lanesPerItem = shape.lanesPerItem;
  options.samplesPerGroup = shape.samplesPerGroup;
  options.selfTest = false;
  const auto engine =
      makeEngine(options, visibility == VisibilityKind::table ? sharedSphereTable() : nullptr);
  const auto reference = referenceEngine(visibility);
  checkMovedSpheres(*engine);
  checkTransfer(*engine);
  const TestScene scene = smallScene();
  CHECK(engine->sphereTableEntries(scene.spheres, scene.receivers) ==
        reference->sphereTableEntries(scene.spheres, scene.receivers));
  for (const int levels : {1, 2}) {
    const ShadingTables tables = tablesFor(scene, 50, levels);
    engine->setShading(tables);
    reference->setShading(tables);
    const auto expected = reference->shade(scene.spheres, scene.receivers);
    const auto radiance = engine->shade(scene.spheres, scene.receivers);
    CHECK(std::memcmp(radiance.data(), expected.data(), expected.size() * sizeof expected[0]) == 0);
  }
  if (visibility == VisibilityKind::exact) checkExponentiation(*engine, scene);  // has no table
}

void checkEveryKernel(std::initializer_list<KernelShape> shapes) {
  if (!haveDevice("opencl")) return;
  for (const auto visibility : {VisibilityKind::exact, VisibilityKind::table})
    for (const KernelShape& shape : shapes) checkEveryKernel(visibility, shape);
}

}  // namespace

// oclgrind, which looks at every access of every work-item, runs these cases too (CMakeLists.txt).
TEST_CASE("every OpenCL kernel on a small scene") {
  checkEveryKernel({{1, 1}, {32, 1}});
}

TEST_CASE("every OpenCL kernel on a small scene, four samples a group") {
  checkEveryKernel({{1, 4}});
}
