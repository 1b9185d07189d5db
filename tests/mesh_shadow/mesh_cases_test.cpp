#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/builtin_meshes.h"
#include "mesh_shadow/mesh_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// |x|, |z| ≤ 2 at y = 0, as a solid's top or as a mesh.
SceneObject makeFloor(bool isMesh) {
  if (isMesh) return groundGrid(2, 3);
  return Solid(BoxShape{{2, 0.5, 2}}, Placement({0, -0.5, 0}));
}

TriangleMesh sheetAt(float height) {
  TriangleMesh sheet = groundGrid(0.5f, 3);
  for (glm::vec3& p : sheet.positions) p.y = height;
  return sheet;
}

double shadowArea(const SceneObject& caster, bool floorIsMesh, const ShadowLight& light,
                  int depth) {
  const SceneShadows shadows({makeFloor(floorIsMesh), caster}, light, {depth, 0});
  constexpr int steps = 1000;
  int count = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      count +=
          shadows.octrees[0].isInShadow({4 * (i + 0.5) / steps - 2, 0, 4 * (j + 0.5) / steps - 2});
  return 16.0 * count / (steps * steps);
}

/// That an area is right within its edge, one smallest cell wide, and at depth 10 within 0.5 %.
void checkArea(const SceneObject& caster, bool floorIsMesh, const ShadowLight& light, double area,
               double perimeter) {
  for (const int depth : {6, 8, 10}) {
    const double found = shadowArea(caster, floorIsMesh, light, depth);
    CAPTURE(depth);
    CHECK(std::abs(found - area) < perimeter * 4.1 / (1 << depth));
    if (depth == 10) CHECK(std::abs(found / area - 1) < 0.005);
  }
}

}  // namespace

TEST_CASE("an open sheet's shadow on a floor of either kind") {
  for (const bool floorIsMesh : {false, true}) {
    CAPTURE(floorIsMesh);
    checkArea(sheetAt(1), floorIsMesh, DirectionalLight{{0.4, 1, 0.3}}, 1, 4);
    // From 3 above the floor, what is 1 above it looks half as large again.
    checkArea(sheetAt(1), floorIsMesh, PointLight{{0.2, 3, 0.1}}, 2.25, 6);
  }
}

TEST_CASE("a solid's shadow on a mesh") {
  const double pi = std::numbers::pi;
  checkArea(Solid(SphereShape{0.5}, Placement({0.1, 1, -0.2})), true,
            DirectionalLight{{0.6, 0.8, 0}}, pi * 0.25 / 0.8, 2 * pi * 0.6);
}

TEST_CASE("a flat sheet is in light on both sides, and cells are not divided for it") {
  for (const double y : {1.0, -1.0}) {
    const SceneShadows shadows({groundGrid(1, 8)}, DirectionalLight{{0.3, y, 0.1}}, {8, 0});
    const auto& leaves = shadows.octrees[0].leaves();
    CHECK(std::ranges::none_of(leaves, [](const ShadowLeaf& leaf) { return leaf.inShadow; }));
    CHECK(std::ranges::count_if(leaves, [](const ShadowLeaf& leaf) { return !leaf.byRay; }) > 0);
  }
}

TEST_CASE("a light on a mesh, and meshes without triangles") {
  const SceneShadows lit({makeFloor(false), sheetAt(1)}, PointLight{{0.1, 1, 0.2}}, {8, 0});
  CHECK(lit.octrees[0].leaves().size() == 1);
  CHECK(lit.octrees[0].isInShadow({0, 0, 0}));
  const SceneShadows empty({makeFloor(false), TriangleMesh{}}, PointLight{{0, 1, 0}}, {8, 0});
  CHECK(empty.octrees[0].leaves().size() == 1);
  CHECK_FALSE(empty.octrees[0].isInShadow({0, 0, 0}));
  CHECK(empty.octrees[1].leaves().empty());
}

TEST_CASE("what lies on a mesh lies in its shadow, whatever single precision does") {
  RandomNumbers random(1);
  const TriangleMesh sheet = randomMesh(3, 1, random);
  const glm::dvec3 normal = randomSample(sheet, random).normal;
  for (const glm::dvec3& towards :
       {normal, -normal, normal + 2.0 * glm::cross(normal, {1, 2, 3})}) {
    const SceneShadows shadows({sheet, sheet}, DirectionalLight{towards}, {5, 0});
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 point = randomSample(sheet, random).position;
      for (const ShadowOctree& octree : shadows.octrees) CHECK(octree.isInShadow(point));
    }
  }
}
