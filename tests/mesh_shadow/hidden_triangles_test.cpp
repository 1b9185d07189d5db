#include "mesh_shadow/hidden_triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/builtin_meshes.h"
#include "mesh_shadow/crossed_triangles.h"
#include "mesh_shadow/mesh_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::vector<std::uint8_t> hiddenIn(const LitMesh& mesh) {
  std::vector<BoxedTriangle> triangles;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) triangles.emplace_back(mesh.corners(t));
  return findHiddenTriangles(mesh, findCrossedTriangles(triangles, mesh.triangles()));
}

void add(TriangleMesh& mesh, TriangleMesh other, float scale, const glm::vec3& place, bool turned) {
  const auto offset = std::uint32_t(mesh.positions.size());
  for (const glm::vec3& p : other.positions) mesh.positions.push_back(scale * p + place);
  for (glm::uvec3 t : other.triangles) {
    if (turned) std::swap(t.x, t.y);
    mesh.triangles.push_back(t + offset);
  }
}

/// Closed meshes: balls, knots, some within or across others, some turned inside out, and balls
/// whose corners are moved at random, so that they cross themselves.
TriangleMesh closedMesh(RandomNumbers& random) {
  TriangleMesh mesh;
  const int count = 1 + int(random() % 3);
  for (int i = 0; i < count; ++i) {
    TriangleMesh part = random() % 3 ? icosphere(2) : torusKnot({2, 3, 48, 8, 0.5});
    if (random() % 3 == 0)
      for (glm::vec3& p : part.positions) p += glm::vec3(randomPoint(random, 0.3));
    const auto scale = float(uniform(random, 0.2, 1));
    add(mesh, part, scale, glm::vec3(randomPoint(random, 0.8)), random() % 3 == 0);
  }
  return mesh;
}

bool isHidden(const LitMesh& mesh, std::uint32_t triangle, const glm::dvec3& point) {
  const glm::dvec3 way = mesh.towardsLight(point);
  const bool isPoint = std::holds_alternative<PointLight>(mesh.light());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (t == triangle) continue;
    TriangleMesh one;
    for (const glm::dvec3& corner : mesh.corners(t)) one.positions.emplace_back(corner);
    one.triangles.emplace_back(0, 1, 2);
    if (meets(point, (isPoint ? 1.0 : 1e3) * way, one, 0)) return true;
  }
  return false;
}

glm::dvec3 pointWithin(const TriangleCorners& t, RandomNumbers& random) {
  const double u = uniform(random, 0.01, 1), v = uniform(random, 0.01, 1),
               w = uniform(random, 0.01, 1);
  return (u * t[0] + v * t[1] + w * t[2]) / (u + v + w);
}

}  // namespace

TEST_CASE("triangles that are said to be hidden are, wherever they are") {
  RandomNumbers random(1);
  int hidden = 0, dark = 0;
  for (int i = 0; i < 60; ++i) {
    ShadowLight light = DirectionalLight{randomDirection(random)};
    if (i % 2) light = PointLight{randomPoint(random, i % 4 == 1 ? 0.5 : 4)};
    const LitMesh mesh(closedMesh(random), light);
    REQUIRE(mesh.isClosed());
    const auto said = hiddenIn(mesh);
    CAPTURE(i);
    for (int k = 0; k < 200; ++k) {
      const auto triangle = std::uint32_t(random() % mesh.triangleCount());
      const bool is = isHidden(mesh, triangle, pointWithin(mesh.corners(triangle), random));
      if (said[triangle]) REQUIRE(is);
      hidden += said[triangle], dark += is;
    }
  }
  MESSAGE(hidden << " of " << dark << " points found");
  CHECK(hidden > 2000);
  CHECK(hidden > dark / 4);
}

TEST_CASE("of a solid, what faces away from the light is hidden, and no more") {
  const TriangleMesh knot = torusKnot({2, 3, 48, 8, 0.5});
  TriangleMesh both;
  add(both, icosphere(2), 1, {0, 0, 0}, false);
  add(both, icosphere(2), 1, {5, 0, 0}, false);
  for (const TriangleMesh& mesh : {icosphere(3), knot, both})
    for (const ShadowLight& light :
         {ShadowLight(PointLight{{2.5, 5, 2}}), ShadowLight(DirectionalLight{{0.3, 1, 0.2}})}) {
      const LitMesh lit(mesh, light);
      const auto hidden = hiddenIn(lit);
      for (std::uint32_t t = 0; t < lit.triangleCount(); ++t)
        CHECK(hidden[t] == (lit.facing(t) < 0));
    }
}

TEST_CASE("inside out, from inside, within another, and open") {
  const PointLight outside{{0, 4, 1}}, inside{{0.1, 0.2, 0.1}};
  const auto count = [](const TriangleMesh& mesh, const ShadowLight& light) {
    const auto hidden = hiddenIn(LitMesh(mesh, light));
    return std::ranges::count(hidden, 1);
  };
  const TriangleMesh ball = icosphere(2);
  TriangleMesh turned;
  add(turned, ball, 1, {0, 0, 0}, true);
  CHECK(count(turned, outside) == count(ball, outside));
  CHECK(count(ball, inside) == 0);
  CHECK(count(turned, inside) == 0);
  TriangleMesh nested = ball;
  add(nested, ball, 0.3f, {0.1f, 0, 0}, false);
  CHECK(count(nested, outside) == count(ball, outside) + std::ptrdiff_t(ball.triangles.size()));
  TriangleMesh shell = ball;  // a hollow: whoever is in it does not see the light
  add(shell, ball, 0.3f, {0.1f, 0, 0}, true);
  CHECK(count(shell, outside) > count(ball, outside));
  TriangleMesh open = ball;
  open.triangles.pop_back();
  CHECK(count(open, outside) == 0);
  CHECK(count(ball, PointLight{ball.positions[0]}) == 0);
  CHECK(count({}, outside) == 0);
}
