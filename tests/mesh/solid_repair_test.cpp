#include "mesh/solid_repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/test_meshes.h"
#include "mesh/topology.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

TriangleMesh triangleMesh(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return {{a, b, c}, {}, {{0, 1, 2}}};
}

/// Each triangle with vertices of its own, started at another of its corners.
TriangleMesh takenApart(const TriangleMesh& mesh) {
  TriangleMesh apart;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    for (const std::uint32_t vertex : {t.y, t.z, t.x})
      apart.positions.push_back(mesh.positions[vertex]);
    apart.triangles.emplace_back(first, first + 1, first + 2);
  }
  return apart;
}

TriangleMesh withDuplicates(TriangleMesh mesh) {
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; i += 5) {
    const glm::uvec3 t = mesh.triangles[i];
    mesh.triangles.push_back(i % 2 ? glm::uvec3(t.z, t.x, t.y) : glm::uvec3(t.z, t.y, t.x));
  }
  return mesh;
}

/// Whatever damage is done to the mesh, the same comes out.
void checkSameFromDamaged(const TriangleMesh& mesh) {
  const BoundingBox bounds = boundingBox(mesh);
  const glm::vec3 size = bounds.upper - bounds.lower;
  const TriangleMesh large = triangleMesh(bounds.lower, bounds.upper + 0.1f * size,
                                          bounds.lower + glm::vec3(1.2f, 0.1f, 0.7f) * size);
  const TriangleMesh small =
      triangleMesh(bounds.lower + 0.40f * size, bounds.lower + glm::vec3(0.41f, 0.4f, 0.42f) * size,
                   bounds.lower + glm::vec3(0.4f, 0.42f, 0.4f) * size);
  const SolidRepair clean = prepareSolid(mesh);
  CHECK(clean.mesh.triangles.size() == mesh.triangles.size());
  CHECK(clean.turnedTriangles + clean.strayTriangles + clean.duplicateTriangles == 0);
  CHECK(same(prepareSolid(clean.mesh).mesh, clean.mesh));

  const auto repaired = [&](const TriangleMesh& damaged) {
    SolidRepair repair = prepareSolid(damaged);
    CHECK(same(repair.mesh, clean.mesh));
    return repair;
  };
  CHECK(repaired(withDuplicates(mesh)).duplicateTriangles == (mesh.triangles.size() + 4) / 5);
  CHECK(repaired(turnedOver(mesh)).turnedTriangles == 0);
  CHECK(repaired(turnedOver(mesh, 9)).turnedTriangles == (mesh.triangles.size() + 8) / 9);
  CHECK(repaired(combined(mesh, large)).strayTriangles == 1);
  CHECK(repaired(combined(mesh, small)).strayTriangles == 1);
  CHECK(repaired(combined(small, mesh)).strayTriangles == 1);
  repaired(takenApart(mesh));
  repaired(withDuplicates(turnedOver(combined(turnedOver(takenApart(mesh), 9), large))));
}

}  // namespace

TEST_CASE("the repaired mesh is the same whatever was wrong with it") {
  checkSameFromDamaged(torusKnot());
  checkSameFromDamaged(combined(sphereAt({0, 0, 0}, 1), sphereAt({1, 0.3f, 0}, 1)));
  checkSameFromDamaged(combined(sphereAt({0, 0, 0}, 1), turnedOver(sphereAt({0, 0, 0}, 0.5f))));
  checkSameFromDamaged(bowl(64));
}

TEST_CASE("bunny and armadillo come out the same whatever was wrong with them") {
  for (const char* name : {"meshes/bunny.obj", "meshes/armadillo.obj"}) {
    const auto path = testData(name);
    if (!path) return;
    const TriangleMesh mesh = loadMesh(*path).mesh;
    checkSameFromDamaged(mesh);
    CHECK(signedVolume(prepareSolid(mesh).mesh) ==
          doctest::Approx(std::abs(signedVolume(mesh))).epsilon(1e-5));
  }
}

TEST_CASE("vertices are joined across seams, and signed zeros and unused ones go") {
  TriangleMesh cube = takenApart(box({0, 0, 0}, {1, 1, 1}));
  for (std::size_t i = 0; i < cube.positions.size(); i += 2)
    for (int axis = 0; axis < 3; ++axis)
      if (cube.positions[i][axis] == 0) cube.positions[i][axis] = -0.0f;
  cube.positions.emplace_back(7, 7, 7);
  cube.triangles.emplace_back(0, 1, 1);
  const SolidRepair repair = prepareSolid(cube);
  CHECK(repair.joinedVertices == 36 - 8);
  CHECK(repair.unusedVertices == 1);
  CHECK(repair.degenerateTriangles == 1);
  CHECK(repair.mesh.positions.size() == 8);
  CHECK(repair.mesh.triangles.size() == 12);
  CHECK(measureTopology(repair.mesh).closed);
  CHECK(std::none_of(repair.mesh.positions.begin(), repair.mesh.positions.end(),
                     [](const glm::vec3& p) {
                       return std::signbit(p.x) || std::signbit(p.y) || std::signbit(p.z);
                     }));
  CHECK(signedVolume(repair.mesh) == doctest::Approx(1));
  CHECK(repair.warnings == std::vector<std::string>{"left out 1 triangle without area"});
}

TEST_CASE("closed parts face outwards, except round cavities") {
  const TriangleMesh outer = box({0, 0, 0}, {4, 4, 4}), inner = box({1, 1, 1}, {3, 3, 3}),
                     core = box({1.5f, 1.5f, 1.5f}, {2, 2, 2}), apart = box({5, 0, 0}, {6, 1, 1});
  const auto volume = [](const TriangleMesh& mesh) {
    return signedVolume(prepareSolid(mesh).mesh);
  };
  CHECK(volume(outer) == doctest::Approx(64));
  CHECK(volume(turnedOver(outer)) == doctest::Approx(64));
  CHECK(volume(combined(outer, apart)) == doctest::Approx(65));
  CHECK(volume(combined(turnedOver(outer), apart)) == doctest::Approx(65));
  CHECK(volume(combined(outer, inner)) == doctest::Approx(72));
  const TriangleMesh hollow = combined(outer, turnedOver(inner));
  CHECK(volume(hollow) == doctest::Approx(56));
  CHECK(volume(turnedOver(hollow)) == doctest::Approx(56));
  CHECK(volume(combined(hollow, core)) == doctest::Approx(56.125));
  CHECK(volume(turnedOver(combined(core, hollow))) == doctest::Approx(56.125));
  // Beside each other, not inside, though the boxes' bounds overlap.
  CHECK(volume(combined(outer, turnedOver(box({3, 3, 3}, {5, 5, 5})))) == doctest::Approx(72));
}

TEST_CASE("pieces of one surface keep how they face to each other") {
  // The six sides of a cube, a little apart, so that none bounds anything on its own.
  const TriangleMesh cube = box({-1, -1, -1}, {1, 1, 1});
  TriangleMesh sides;
  for (std::size_t side = 0; side < 6; ++side) {
    TriangleMesh piece = cube;
    piece.triangles = {cube.triangles[2 * side], cube.triangles[2 * side + 1]};
    piece = takenApart(piece);
    const int axis = static_cast<int>(side) / 2;
    for (glm::vec3& p : piece.positions) p[axis] *= 1.001f;
    sides = combined(sides, piece);
  }
  const SolidRepair repair = prepareSolid(sides), turned = prepareSolid(turnedOver(sides));
  CHECK(repair.strayTriangles == 0);
  CHECK(repair.turnedParts == 0);
  CHECK(turned.turnedParts == 6);
  CHECK(same(repair.mesh, turned.mesh));
  CHECK(signedVolume(repair.mesh) == doctest::Approx(8.008));
}

TEST_CASE("a strip with one side only is kept") {
  TriangleMesh strip;
  constexpr int segments = 30;
  for (int i = 0; i < segments; ++i) {
    const double around = 2 * std::numbers::pi * i / segments;
    for (const double across : {-0.3, 0.3}) {
      const double radius = 1 + across * std::cos(around / 2);
      strip.positions.emplace_back(radius * std::cos(around), radius * std::sin(around),
                                   across * std::sin(around / 2));
    }
  }
  for (std::uint32_t i = 0; i < segments; ++i) {
    const bool last = i + 1 == segments;
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.triangles.emplace_back(a, b, c);
    strip.triangles.emplace_back(c, b, d);
  }
  const SolidRepair repair = prepareSolid(strip);
  CHECK(repair.mesh.triangles.size() == 2 * segments);
  CHECK(measureTopology(repair.mesh).misorientedEdges > 0);
  CHECK(same(prepareSolid(turnedOver(strip, 4)).mesh, prepareSolid(turnedOver(strip, 7)).mesh));
}

TEST_CASE("stray triangles go, leaf cards, flags and lids stay") {
  const TriangleMesh trunk = sphereAt({0, 0, 0}, 1, 3);
  Random random(1);
  TriangleMesh crumbs = trunk, leaves = trunk;
  for (int i = 0; i < 40; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    const glm::vec3 at = 3.0f * glm::vec3(x, y, z);
    const auto leaf = [&](float size) {
      return triangleMesh(at, at + glm::vec3(size, 0, 0), at + glm::vec3(0, size, size));
    };
    crumbs = combined(crumbs, leaf(0.01f));
    leaves = combined(leaves, leaf(0.2f));
  }
  const SolidRepair withoutCrumbs = prepareSolid(crumbs);
  CHECK(withoutCrumbs.strayTriangles == 40);
  CHECK(same(withoutCrumbs.mesh, prepareSolid(trunk).mesh));
  CHECK(prepareSolid(leaves).strayTriangles == 0);

  const TriangleMesh flag = triangleMesh({2, 0, 0}, {2, 1, 0}, {2, 0, 1});
  CHECK(prepareSolid(combined(box({0, 0, 0}, {1, 1, 1}), flag)).strayTriangles == 0);
  CHECK(prepareSolid(combined(trunk, flag)).strayTriangles == 1);
  // A fin on an edge, which then has three triangles.
  TriangleMesh fin = trunk;
  fin.positions.emplace_back(3, 3, 3);
  fin.triangles.emplace_back(fin.triangles[7].x, fin.triangles[7].y, fin.positions.size() - 1);
  CHECK(same(prepareSolid(fin).mesh, prepareSolid(trunk).mesh));

  // One triangle of a sphere taken out and put back, a little off or far away.
  const TriangleMesh coarse = sphereAt({0, 0, 0}, 1, 2);
  const auto withLid = [&](const glm::vec3& moved) {
    TriangleMesh holed = coarse;
    const glm::uvec3 t = coarse.triangles.back();
    holed.triangles.pop_back();
    return combined(holed,
                    triangleMesh(coarse.positions[t.x] + moved, coarse.positions[t.y] + moved,
                                 coarse.positions[t.z] + moved));
  };
  CHECK(prepareSolid(withLid(glm::vec3(1e-4f))).strayTriangles == 0);
  CHECK(prepareSolid(withLid(glm::vec3(1))).strayTriangles == 1);
}

TEST_CASE("walls between touching solids go, sheets in two layers become one") {
  for (const TriangleMesh& stack : {cubeStack(3), turnedOver(cubeStack(3), 5)}) {
    const SolidRepair repair = prepareSolid(stack);
    // 54 squares between 27 cubes, 54 on the surface, two triangles each.
    CHECK(repair.duplicateTriangles == 108);
    CHECK(repair.wallTriangles == 108);
    const MeshTopology topology = measureTopology(repair.mesh);
    CHECK(topology.closed);
    CHECK(topology.misorientedEdges == 0);
    CHECK(surfaceArea(repair.mesh) == doctest::Approx(54));
    CHECK(signedVolume(repair.mesh) == doctest::Approx(27));
  }
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 1);
  const TriangleMesh doubled = combined(sphere, turnedOver(sphere));
  CHECK(same(prepareSolid(doubled).mesh, prepareSolid(sphere).mesh));
  TriangleMesh sheet = groundGrid(1, 4);
  sheet.positions[12].y = 0.5f;
  const SolidRepair single = prepareSolid(combined(sheet, turnedOver(sheet)));
  CHECK(single.mesh.triangles.size() == 32);
  CHECK(single.duplicateTriangles == 32);
  CHECK(single.wallTriangles == 0);
}

TEST_CASE("the warnings say what was done") {
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 1);
  TriangleMesh bad = turnedOver(turnedOver(sphere), 100);  // 13 of 1280 as they should be
  bad = combined(bad, triangleMesh({5, 0, 0}, {6, 0, 0}, {5, 1, 0}));
  bad.triangles.push_back(bad.triangles[3]);
  bad.triangles.push_back(bad.triangles[4]);
  CHECK(prepareSolid(bad).warnings ==
        std::vector<std::string>{"left out 2 duplicate triangles", "left out 1 stray triangle",
                                 "turned 13 triangles so that neighbours agree",
                                 "turned 1 part of the surface that faced inwards"});
  CHECK(prepareSolid(sphere).warnings.empty());
  CHECK(prepareSolid({}).mesh.triangles.empty());
}
