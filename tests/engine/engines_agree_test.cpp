#include <doctest/doctest.h>

#include <cstring>

#include "base/error.h"
#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Equal in every bit: 0 and −0 differ, NaN equals itself.
bool sameBits(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

void checkAllStages(Engine& reference, Engine& engine, const TestScene& scene) {
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
  REQUIRE(sameBits(engine.shade(scene.spheres, scene.receivers),
                   reference.shade(scene.spheres, scene.receivers)));
}

}  // namespace

TEST_CASE("reference and OpenCL agree in every bit on 200 random scenes") {
  for (const auto& [visibility, lanesPerItem] :
       {std::pair(VisibilityKind::table, 32), std::pair(VisibilityKind::table, 1),
        std::pair(VisibilityKind::exact, 32), std::pair(VisibilityKind::exact, 1)}) {
    const auto engine = openClEngine(visibility, lanesPerItem);
    if (!engine) return;
    const auto reference = referenceEngine(visibility);
    for (unsigned seed = 0; seed < 200; ++seed) {
      CAPTURE(int(visibility));
      CAPTURE(lanesPerItem);
      CAPTURE(seed);
      const TestScene scene = randomScene(seed);
      checkAllStages(*reference, *engine, scene);
      checkRadiance(*reference, *engine, scene, seed % 2 ? 200 : 50, 1 + seed / 2 % 2);
    }
  }
}

TEST_CASE("reference and OpenCL agree in every bit on the complete triple product") {
  const auto engine = openClEngine();
  if (!engine) return;
  const auto reference = referenceEngine();
  for (unsigned seed = 1000; seed < 1006; ++seed)
    for (const int terms : {0, 1, 6137, 6144})
      checkRadiance(*reference, *engine, randomScene(seed), terms, 1 + int(seed % 2));
}

TEST_CASE("a frame larger than a batch equals its receivers one by one") {
  const auto engine = openClEngine();
  if (!engine) return;
  const TestScene scene = randomScene(7, 5000);
  engine->setShading(tablesFor(scene, 30, 2));
  const auto whole = engine->shade(scene.spheres, scene.receivers);
  for (const std::size_t i : {0u, 2047u, 2048u, 4999u}) {
    const auto one = engine->shade(scene.spheres, ReceiverSpan(scene.receivers).part(i, 1));
    CHECK(sameBits(one, {whole[i]}));
  }
}

TEST_CASE("no spheres and no receivers are frames too") {
  const auto engine = openClEngine();
  if (!engine) return;
  TestScene scene = randomScene(3);
  const auto reference = referenceEngine();
  scene.spheres.clear();
  checkRadiance(*reference, *engine, scene, 200, 2);
  CHECK(engine->shade(scene.spheres, Receivers{}).empty());
}

TEST_CASE("an unknown engine or device is refused in words") {
  const auto table = sharedSphereTable();
  CHECK_THROWS_WITH_AS(makeEngine({"vulkan", "", 0}, table),
                       "unknown engine 'vulkan': use auto, reference or opencl", InputError);
  CHECK_THROWS_AS(makeEngine({"opencl", "no such device", 0}, table), InputError);
  CHECK_THROWS_AS(makeEngine({"opencl", "99", 0}, table), InputError);
}
