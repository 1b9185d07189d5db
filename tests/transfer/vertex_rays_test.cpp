#include "transfer/vertex_rays.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "mesh/random.h"
#include "transfer_meshes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A long gutter of two planes that rise to both sides of its bottom, turned by a matrix whose
/// columns are across, along and up; vertices 0 to 2 lie along the bottom.
TriangleMesh gutter(const glm::mat3& turned, float slope, float size) {
  TriangleMesh mesh;
  for (const float x : {0.0f, -1.0f, 1.0f})
    for (const float y : {-1.0f, 0.0f, 1.0f})
      mesh.positions.push_back(turned * (size * glm::vec3(x, y, slope * std::abs(x))));
  mesh.normals.assign(9, turned[2]);
  for (const std::uint32_t side : {3u, 6u})
    for (const std::uint32_t part : {0u, 1u}) {
      mesh.triangles.emplace_back(part, part + 1, side + part);
      mesh.triangles.emplace_back(part + 1, side + part + 1, side + part);
    }
  return mesh;
}

}  // namespace

TEST_CASE("rays from the bottom of a gutter are blocked where its sides are, and nowhere else") {
  // Every face of a gutter touches its middle vertex or lies in a plane of one that does.
  Random random(8);
  VertexView view;
  for (int i = 0; i < 20; ++i) {
    const glm::mat3 turned = glm::mat3(glm::rotate(
        glm::mat4(1), 6.28f * float(random.uniform()),
        glm::normalize(glm::vec3(random.uniform(), random.uniform(), random.uniform()))));
    const float slope = 0.05f + float(random.uniform()), size = i % 2 ? 1e-3f : 1e3f;
    const TriangleMesh mesh = gutter(turned, slope, size);
    const VertexRays rays(mesh, 4096, i);
    rays.cast(1, view);
    std::size_t wrong = 0, reflecting = 0;
    for (std::size_t ray = 0; ray < view.blocked.size(); ++ray) {
      const glm::vec3 d = glm::transpose(turned) * view.directions[ray];
      const float above = d.z - slope * std::abs(d.x);
      if (std::abs(above) > 1e-5f) wrong += view.blocked[ray] != (above < 0);
      reflecting += above < 0;
    }
    CHECK(wrong == 0);
    CHECK(std::abs(double(view.blockedCount) - double(reflecting)) <= 2);
    CHECK(view.reflectors.size() == view.blockedCount);
    // 1/π ∫ cos over a wedge: both sides together take 1 − cos of their angle.
    CHECK(double(view.blockedCount) / 4096 ==
          doctest::Approx(1 - 1 / std::hypot(1.0, slope)).epsilon(0.02).scale(0.1));
  }
}

TEST_CASE("a vertex in the middle of a face that it is no corner of is not blocked by it") {
  // Rounded coordinates put half of such vertices a rounding error below the face. Rays that meet
  // it further off than nearer hits are ignored rise by less than 1 in 16: a 256th of all.
  Random random(10);
  VertexView view;
  for (int i = 0; i < 50; ++i) {
    const auto coordinate = [&] { return 0.2f + float(random.uniform()); };
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, coordinate()}, {0, 4, coordinate()}};
    const glm::vec3 a = mesh.positions[1], b = mesh.positions[2];
    const glm::vec3 normal = glm::normalize(glm::cross(a, b));
    for (const float shift : {0.0f, 0.1f, 0.2f})
      mesh.positions.push_back((0.3f + shift) * a + (0.3f + shift * shift) * b);
    mesh.normals.assign(6, normal);
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    VertexRays(mesh, 1024, i).cast(3, view);
    CHECK(view.blockedCount <= 8);
  }
}

TEST_CASE("every vertex and every seed has its own directions, always the same") {
  const TriangleMesh ground = groundGrid(1, 2);
  const auto directions = [&](std::uint64_t seed, std::uint32_t vertex) {
    VertexView view;
    VertexRays(ground, 16, seed).cast(vertex, view);
    return view.directions;
  };
  CHECK(directions(1, 0) == directions(1, 0));
  CHECK(directions(1, 0) != directions(1, 1));
  CHECK(directions(1, 0) != directions(2, 0));
}

TEST_CASE("places on the surface keep their weights to a 65535th") {
  const SurfacePlace place{3, 16384, 32768};
  const glm::vec3 w = place.weights();
  CHECK(w.x + w.y + w.z == doctest::Approx(1).epsilon(1e-7));
  CHECK(w.y == doctest::Approx(0.25).epsilon(1e-4));
  CHECK(w.z == doctest::Approx(0.5).epsilon(1e-4));
}
