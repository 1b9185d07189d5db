#include "mesh_shadow/hidden_triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/builtin_meshes.h"
#include "mesh_shadow/crossed_triangles.h"
#include "mesh_shadow/mesh_scenes.h"
#include "mesh_shadow/plain_triangles.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::vector<std::uint8_t> crossedIn(const LitMesh& mesh) {
  std::vector<BoxedTriangle> triangles;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) triangles.emplace_back(mesh.corners(t));
  return findCrossedTriangles(triangles, mesh.triangles());
}

std::vector<std::uint8_t> hiddenIn(const LitMesh& mesh) {
  return findHiddenTriangles(mesh, crossedIn(mesh));
}

/// Whether a point lies in the shadow of triangles other than its own two.
bool isHidden(const LitMesh& mesh, std::uint32_t triangle, std::uint32_t other,
              const glm::dvec3& point) {
  const glm::dvec3 way = mesh.towardsLight(point);
  const bool isPoint = std::holds_alternative<PointLight>(mesh.light());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (t == triangle || t == other) continue;
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
    const LitMesh mesh(randomClosedMesh(random), light);
    REQUIRE(mesh.isClosed());
    const auto said = hiddenIn(mesh);
    CAPTURE(i);
    for (int k = 0; k < 200; ++k) {
      const auto triangle = std::uint32_t(random() % mesh.triangleCount());
      const bool is =
          isHidden(mesh, triangle, triangle, pointWithin(mesh.corners(triangle), random));
      if (said[triangle]) REQUIRE(is);
      hidden += said[triangle], dark += is;
    }
  }
  MESSAGE(hidden << " of " << dark << " points found");
  CHECK(hidden > 2000);
  CHECK(hidden > dark / 4);
}

TEST_CASE("folds that are said to be hidden are, all along") {
  RandomNumbers random(2);
  int found = 0, silhouette = 0;
  for (int i = 0; i < 40; ++i) {
    ShadowLight light = DirectionalLight{randomDirection(random)};
    if (i % 2) light = PointLight{randomPoint(random, 4)};
    const LitMesh mesh(i % 4 ? torusKnot({2, 3, 48, 8, 0.5}) : randomClosedMesh(random), light);
    const auto crossed = crossedIn(mesh);
    const auto plain = findPlainTriangles(mesh, crossed);
    const auto hidden = findHiddenTriangles(mesh, crossed);
    CAPTURE(i);
    for (std::size_t edge = 0; edge < mesh.silhouette().size(); ++edge) {
      ++silhouette;
      if (!isHiddenFold(mesh, edge, plain, hidden)) continue;
      ++found;
      const auto [a, b] = mesh.silhouette()[edge];
      const std::uint32_t corner = mesh.silhouetteCorners()[edge];
      const std::uint32_t other = mesh.neighbor(corner / 3, int(corner % 3));
      for (const double t : {0.01, 0.3, 0.5, 0.8, 0.99})
        REQUIRE(isHidden(mesh, corner / 3, other,
                         (1 - t) * mesh.positions()[a] + t * mesh.positions()[b]));
    }
  }
  MESSAGE(found << " of " << silhouette << " edges are hidden folds");
  CHECK(found > 200);
  const LitMesh ball(icosphere(3), PointLight{{2.5, 5, 2}});
  const std::vector<std::uint8_t> all(ball.triangleCount(), 1), hidden = hiddenIn(ball);
  for (std::size_t edge = 0; edge < ball.silhouette().size(); ++edge)
    CHECK_FALSE(isHiddenFold(ball, edge, all, hidden));
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
