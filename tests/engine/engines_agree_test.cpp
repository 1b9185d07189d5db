#include <doctest/doctest.h>

#include <cstring>

#include "base/error.h"
#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Equal in every bit: 0 and −0 differ, NaN equals itself.
template <typename Value>
bool sameBits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

void checkMovedSpheres(Engine& reference, Engine& engine, unsigned seed) {
  constexpr int counts[] = {1, 7, 8, 9, 33, 70};
  const auto [binding, vertices] = randomBinding(seed, counts[seed % 6]);
  reference.setSphereBinding(binding);
  engine.setSphereBinding(binding);
  const auto expected = reference.moveSpheres(vertices);
  REQUIRE(expected.size() == binding.sphereCount());
  REQUIRE(sameBits(engine.moveSpheres(vertices), expected));
}

void checkAllStages(Engine& reference, Engine& engine, const TestScene& scene) {
  REQUIRE(engine.sphereTableEntries(scene.spheres, scene.receivers) ==
          reference.sphereTableEntries(scene.spheres, scene.receivers));
  const auto cubes = reference.mergeBitCubes(scene.spheres, scene.receivers);
  REQUIRE(engine.mergeBitCubes(scene.spheres, scene.receivers) == cubes);
  const auto occlusion = reference.transformOcclusion(cubes);
  REQUIRE(engine.transformOcclusion(cubes) == occlusion);
}

void checkRadiance(Engine& reference, Engine& engine, const TestScene& scene, int terms,
                   int levels) {
  const ShadingTables tables = tablesFor(scene, terms, levels);
  reference.setShading(tables);
  engine.setShading(tables);
  const auto expected = reference.shade(scene.spheres, scene.receivers);
  REQUIRE(sameBits(engine.shade(scene.spheres, scene.receivers), expected));
  const auto occlusion =
      reference.transformOcclusion(reference.mergeBitCubes(scene.spheres, scene.receivers));
  REQUIRE(sameBits(engine.tripleProduct(occlusion, scene.receivers.lobes), expected));
}

void checkAgreement(const std::string& engineName, const KernelShape& shape, unsigned seeds) {
  for (const auto visibility : {VisibilityKind::table, VisibilityKind::exact}) {
    const auto engine = testEngine(engineName, visibility, shape);
    if (!engine) return;
    const auto reference = referenceEngine(visibility);
    for (unsigned seed = 0; seed < seeds; ++seed) {
      CAPTURE(int(visibility));
      CAPTURE(shape.lanesPerItem);
      CAPTURE(shape.samplesPerGroup);
      CAPTURE(seed);
      checkMovedSpheres(*reference, *engine, seed);
      const TestScene scene = randomScene(seed);
      checkAllStages(*reference, *engine, scene);
      checkRadiance(*reference, *engine, scene, seed % 2 ? 200 : 50, 1 + seed / 2 % 2);
    }
  }
}

}  // namespace

TEST_CASE("reference and OpenCL agree in every bit, all lanes in an item") {
  checkAgreement("opencl", {32, 1}, 100);
  checkAgreement("opencl", {32, 5}, 25);
}

TEST_CASE("reference and OpenCL agree in every bit, a lane an item") {
  checkAgreement("opencl", {1, 1}, 100);
  checkAgreement("opencl", {1, 3}, 25);
  checkAgreement("opencl", {1, 8}, 25);
}

TEST_CASE("reference and CUDA on the host agree in every bit") {
  checkAgreement("cuda-host", {1, 4}, 60);
  checkAgreement("cuda-host", {1, 1}, 20);
  checkAgreement("cuda-host", {1, 3}, 20);
  checkAgreement("cuda-host", {1, 8}, 20);
}

TEST_CASE("reference and CUDA agree in every bit") {
  checkAgreement("cuda", {1, 4}, 100);
  checkAgreement("cuda", {1, 1}, 25);
  checkAgreement("cuda", {1, 3}, 25);
  checkAgreement("cuda", {1, 8}, 25);
}

TEST_CASE("reference and OpenCL agree in every bit on the complete triple product") {
  const auto engine = testEngine("opencl");
  if (!engine) return;
  const auto reference = referenceEngine();
  for (unsigned seed = 1000; seed < 1006; ++seed)
    for (const int terms : {0, 1, 6137, 6144})
      checkRadiance(*reference, *engine, randomScene(seed), terms, 1 + int(seed % 2));
}

TEST_CASE("a frame larger than a batch equals its receivers one by one") {
  for (const char* name : {"cuda-host", "opencl"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    const TestScene scene = randomScene(7, 5000);
    engine->setShading(tablesFor(scene, 30, 2));
    const auto whole = engine->shade(scene.spheres, scene.receivers);
    for (const std::size_t i : {0u, 2047u, 2048u, 4999u}) {
      const auto one = engine->shade(scene.spheres, ReceiverSpan(scene.receivers).part(i, 1));
      CHECK(sameBits(one, {whole[i]}));
    }
  }
}

TEST_CASE("a binding takes the place of the one before, and may be empty") {
  for (const char* name : {"cuda-host", "opencl"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    for (const int count : {70, 3, 40}) {
      const auto [binding, vertices] = randomBinding(5, count);
      engine->setSphereBinding(binding);
      const auto expected = moveSpheres(binding, vertices);
      CHECK(sameBits(engine->moveSpheres(vertices), expected));
      CHECK(sameBits(engine->moveSpheres(vertices), expected));
    }
    engine->setSphereBinding({});
    CHECK(engine->moveSpheres({}).empty());
  }
}

TEST_CASE("no spheres and no receivers are frames too") {
  for (const char* name : {"cuda-host", "opencl"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    TestScene scene = randomScene(3);
    const auto reference = referenceEngine();
    scene.spheres.clear();
    checkRadiance(*reference, *engine, scene, 200, 2);
    CHECK(engine->mergeBitCubes(scene.spheres, scene.receivers) ==
          std::vector<BitCube>(scene.receivers.size()));
    CHECK(engine->shade(scene.spheres, Receivers{}).empty());
  }
}

TEST_CASE("an unknown engine, device or shape is refused in words") {
  const auto refused = [](const EngineOptions& options) { makeEngine(options, nullptr); };
  CHECK_THROWS_WITH_AS(refused({.engine = "vulkan"}),
                       "unknown engine 'vulkan': use auto, reference, opencl, cuda or cuda-host",
                       InputError);
  CHECK_THROWS_AS(refused({.engine = "opencl", .device = "no such device"}), InputError);
  CHECK_THROWS_AS(refused({.engine = "opencl", .device = "99"}), InputError);
  CHECK_THROWS_AS(refused({.engine = "cuda", .device = "99"}), InputError);
  CHECK_THROWS_AS(refused({.engine = "opencl", .lanesPerItem = 7}), InputError);
  CHECK_THROWS_AS(refused({.engine = "cuda-host", .lanesPerItem = 32}), InputError);
  CHECK_THROWS_AS(refused({.engine = "cuda-host", .samplesPerGroup = 9}), InputError);
}
