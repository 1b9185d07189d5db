#include "transfer/vertex_fan.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "mesh/random.h"
#include "transfer/vertex_faces.h"
#include "transfer_meshes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

VertexFan fanOf(const TriangleMesh& mesh, std::uint32_t vertex) {
  return {mesh, vertex, VertexFaces(mesh).around(vertex)};
}

/// A direction over the hemisphere of `normal`.
glm::dvec3 randomOver(const glm::dvec3& normal, Random& random) {
  for (;;) {
    const glm::dvec3 p(2 * random.uniform() - 1, 2 * random.uniform() - 1,
                       2 * random.uniform() - 1);
    if (glm::length(p) < 1 && glm::dot(p, normal) > 0) return glm::normalize(p);
  }
}

/// A pyramid without its base: apex at the origin, normals up, four faces to a square at `height`.
TriangleMesh pyramid(float height) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, height}, {-1, 1, height}, {-1, -1, height}, {1, -1, height}};
  mesh.normals.assign(5, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  return mesh;
}

}  // namespace

TEST_CASE("the faces at a position are found across creases") {
  const TriangleMesh cube = faceted(box({0, 0, 0}, {1, 1, 1}));
  const VertexFaces faces(cube);
  std::size_t uses = 0;
  for (std::uint32_t v = 0; v < cube.positions.size(); ++v) {
    const auto around = faces.around(v);
    CHECK(std::ranges::is_sorted(around));
    std::size_t expected = 0;
    for (const glm::uvec3& t : cube.triangles)
      for (int corner = 0; corner < 3; ++corner)
        expected += cube.positions[t[corner]] == cube.positions[v];
    CHECK(around.size() == expected);
    uses += around.size();
  }
  CHECK(uses > 3 * cube.triangles.size());
  TriangleMesh unused = cube;
  unused.positions.emplace_back(7, 7, 7);
  CHECK(VertexFaces(unused).around(std::uint32_t(cube.positions.size())).empty());
}

TEST_CASE("faces below the plane of the normal block nothing") {
  const TriangleMesh sphere = icosphere(2), cube = faceted(box({0, 0, 0}, {1, 1, 1}));
  for (const TriangleMesh* mesh : {&sphere, &cube})
    for (std::uint32_t v = 0; v < mesh->positions.size(); ++v)
      CHECK_FALSE(fanOf(*mesh, v).mayBlock());
  CHECK_FALSE(fanOf(pyramid(-1), 0).mayBlock());
  CHECK_FALSE(fanOf(pyramid(0), 0).mayBlock());
}

TEST_CASE("in a pit what goes through the faces is blocked, whichever way they are wound") {
  // Up in the pyramid of half-angle 45° is what lies above all of its faces: z > |x|, |y|.
  for (const bool turned : {false, true}) {
    const TriangleMesh mesh = turned ? turnedOver(pyramid(1)) : pyramid(1);
    const VertexFan fan = fanOf(mesh, 0);
    REQUIRE(fan.mayBlock());
    Random random(4);
    int blocked = 0;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 d = randomOver({0, 0, 1}, random);
      const auto face = fan.blockingFace(d);
      REQUIRE(face.has_value() == (d.z < std::max(std::abs(d.x), std::abs(d.y))));
      if (!face) continue;
      ++blocked;
      CHECK(face->corner == 0);
      CHECK(face->lit);
    }
    CHECK(blocked > 500);
  }
}

TEST_CASE("in a corner of a room the other walls block, at an edge the other wall") {
  const TriangleMesh mesh = room();
  Random random(5);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 inward = -glm::sign(glm::dvec3(mesh.positions[v]));
    const VertexFan fan = fanOf(mesh, v);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 d = randomOver(glm::dvec3(mesh.normals[v]), random);
      const bool intoTheRoom = d.x * inward.x > 0 && d.y * inward.y > 0 && d.z * inward.z > 0;
      const auto face = fan.blockingFace(d);
      REQUIRE(face.has_value() == !intoTheRoom);
      if (!face) continue;
      CHECK(face->lit);
      // It is seen from the inside: its normal is against the direction.
      const glm::uvec3& t = mesh.triangles[face->triangle];
      CHECK(glm::dot(d, glm::dvec3(mesh.normals[t.x])) < 0);
      CHECK(mesh.positions[t[face->corner]] == mesh.positions[v]);
    }
  }
}

TEST_CASE("a saddle blocks what lies below it") {
  // Height x² − y² round a vertex: the surface of directions is z = x² − y² for the ring's points.
  constexpr int segments = 720;
  TriangleMesh mesh;
  mesh.positions.emplace_back(0, 0, 0);
  const auto height = [](double angle) { return std::cos(2 * angle); };
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / segments;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), height(angle));
    mesh.triangles.emplace_back(0, i + 1, (i + 1) % segments + 1);
  }
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  const VertexFan fan = fanOf(mesh, 0);
  Random random(6);
  int blocked = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 d = randomOver({0, 0, 1}, random);
    const double above =
        d.z / std::hypot(d.x, d.y) - height(std::atan2(d.y, d.x));  // slope against the surface's
    if (std::abs(above) < 1e-3) continue;                           // the ring is made of chords
    const auto face = fan.blockingFace(d);
    REQUIRE(face.has_value() == (above < 0));
    blocked += face.has_value();
  }
  CHECK(blocked > 100);
}
