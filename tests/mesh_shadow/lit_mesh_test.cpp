#include "mesh_shadow/lit_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "error_text.h"
#include "mesh/builtin_meshes.h"
#include "mesh_shadow/mesh_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// How many edges of the silhouette each vertex has.
std::map<std::uint32_t, int> degrees(const LitMesh& mesh) {
  std::map<std::uint32_t, int> result;
  for (const auto& [a, b] : mesh.silhouette()) ++result[a], ++result[b];
  return result;
}

}  // namespace

TEST_CASE("a ball's silhouette is one loop, which leaves as much of it in light as it should") {
  const TriangleMesh ball = icosphere(3);
  const LitMesh lit(ball, DirectionalLight{{0.3, 1, 0.2}});
  CHECK(lit.silhouette().size() > 20);
  for (const auto& [vertex, degree] : degrees(lit)) CHECK(degree == 2);
  CHECK(degrees(lit).size() == lit.silhouette().size());
  int facing = 0;
  for (std::uint32_t t = 0; t < lit.triangleCount(); ++t) facing += lit.facing(t) > 0;
  CHECK(facing == doctest::Approx(lit.triangleCount() / 2.0).epsilon(0.05));
  // From twice its radius a ball shows (1 − 1/2)/2 of itself.
  const LitMesh near(ball, PointLight{{1.2, 1.6, 0}});
  facing = 0;
  for (std::uint32_t t = 0; t < near.triangleCount(); ++t) facing += near.facing(t) > 0;
  CHECK(facing == doctest::Approx(near.triangleCount() / 4.0).epsilon(0.1));
}

TEST_CASE("turned triangles change no silhouette; doubled ones change none either") {
  RandomNumbers random(1);
  for (int kind = 0; kind < meshKinds; ++kind) {
    const TriangleMesh mesh = randomMesh(kind, 1, random);
    TriangleMesh turned = mesh, doubled = mesh;
    for (std::size_t i = 0; i < turned.triangles.size(); i += 3)
      std::swap(turned.triangles[i].x, turned.triangles[i].y);
    doubled.triangles.insert(doubled.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    const PointLight light{randomPoint(random, 4)};
    const auto silhouette = LitMesh(mesh, light).silhouette();
    CHECK(silhouette == LitMesh(turned, light).silhouette());
    CHECK(silhouette == LitMesh(doubled, light).silhouette());
  }
}

TEST_CASE("a flat sheet's silhouette is its boundary; edge-on, all of its edges") {
  const TriangleMesh sheet = groundGrid(1, 4);
  CHECK(LitMesh(sheet, DirectionalLight{{0.1, 1, 0}}).silhouette().size() == 16);
  CHECK(LitMesh(sheet, PointLight{{5, -3, 1}}).silhouette().size() == 16);
  const LitMesh edgeOn(sheet, DirectionalLight{{1, 0, 0.3}});
  CHECK(edgeOn.silhouette().size() == 4 * 5 * 2 + 16);
  CHECK(edgeOn.facing(0) == 0);
}

TEST_CASE("triangles overlap where some point of one has a point of the other in its way") {
  RandomNumbers random(2);
  int apart = 0;
  for (int kind = 0; kind < meshKinds; ++kind) {
    const TriangleMesh mesh = randomMesh(kind, 0, random);
    const PointLight light{3.0 * randomDirection(random)};
    const LitMesh lit(mesh, light);
    for (int i = 0; i < 4000; ++i) {
      const ObjectSample sample = randomSample(mesh, random);
      const std::size_t other = random() % mesh.triangles.size();
      if (other == sample.triangle) continue;
      const auto hit = meets(sample.position, light.position - sample.position, mesh, other);
      const bool mayOverlap = lit.mayOverlap(std::uint32_t(sample.triangle), std::uint32_t(other));
      if (hit) REQUIRE(mayOverlap);
      apart += !mayOverlap;
    }
  }
  CHECK(apart > 10000);
}

TEST_CASE("light on a mesh, and meshes that are none") {
  const TriangleMesh sheet = groundGrid(1, 1);
  CHECK(LitMesh(sheet, PointLight{{0.3, 0, 0.4}}).holdsLight());
  CHECK_FALSE(LitMesh(sheet, PointLight{{0.3, 0.001, 0.4}}).holdsLight());
  CHECK_FALSE(LitMesh(sheet, PointLight{{1.3, 0, 0.4}}).holdsLight());
  CHECK(LitMesh({}, PointLight{}).bounds().isEmpty());
  TriangleMesh broken = sheet;
  broken.positions[0].x = std::numeric_limits<float>::quiet_NaN();
  CHECK(contains(inputErrorOf([&] { LitMesh(broken, PointLight{}); }), "finite coordinates"));
  TriangleMesh collapsed = sheet;
  for (glm::uvec3& t : collapsed.triangles) t.z = t.y;
  CHECK(LitMesh(collapsed, PointLight{}).triangleCount() == 0);
}
