#include "mesh/mesh_measures.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "mesh/builtin_meshes.h"
#include "mesh/inside_test.h"
#include "mesh/mesh_transform.h"
#include "mesh/random.h"

using namespace haarlight;

namespace {

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  for (const auto& t : b.triangles) a.triangles.push_back(t + offset);
  return a;
}

glm::vec3 randomPoint(Random& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return glm::vec3(3 * x - 1.5, 3 * y - 1.5, 3 * z - 1.5);
}

/// Number of points on the wrong side of a unit sphere, not counting those near its surface.
int wrongSides(const InsideTest& inside) {
  Random random(5);
  int wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 point = randomPoint(random);
    const float radius = glm::length(point);
    if (std::abs(radius - 0.99f) > 0.02f) wrong += inside.contains(point) != (radius < 0.99f);
  }
  return wrong;
}

}  // namespace

TEST_CASE("surface samples lie evenly on the triangles, the same for a seed") {
  const TriangleMesh sphere = icosphere(5);
  const auto samples = sampleSurface(sphere, 20000, 7);
  CHECK(samples.size() == 20000);
  CHECK(samples == sampleSurface(sphere, 20000, 7));
  CHECK(samples != sampleSurface(sphere, 20000, 8));
  // Mean and second moments of the unit sphere: 0 and 1/3, within five standard errors.
  glm::dvec3 mean(0), squares(0);
  for (const auto& p : samples) {
    CHECK(std::abs(glm::length(p) - 1) < 2e-3f);
    mean += glm::dvec3(p) / 20000.0;
    squares += glm::dvec3(p) * glm::dvec3(p) / 20000.0;
  }
  const double meanError = std::sqrt(1.0 / 3 / 20000);
  const double squareError = std::sqrt((1.0 / 5 - 1.0 / 9) / 20000);
  for (int i = 0; i < 3; ++i) {
    CHECK(std::abs(mean[i]) < 5 * meanError);
    CHECK(std::abs(squares[i] - 1.0 / 3) < 5 * squareError + 2e-3);
  }
  CHECK(sampleSurface(TriangleMesh{}, 10, 0).empty());
}

TEST_CASE("bounds leave out vertices without triangle") {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {9, 9, 9}}, {}, {{0, 1, 2}}};
  CHECK(boundingBox(mesh).upper == glm::vec3(1, 2, 0));
  CHECK(boundingBox(mesh).lower == glm::vec3(0));
}

TEST_CASE("the inside of spheres: closed, turned inside out, with a hole, overlapping") {
  const TriangleMesh sphere = icosphere(4);
  CHECK(wrongSides(InsideTest(sphere)) == 0);

  TriangleMesh turned = sphere;
  for (auto& t : turned.triangles) std::swap(t.x, t.y);
  CHECK(signedVolume(turned) == doctest::Approx(-signedVolume(sphere)));
  CHECK(wrongSides(InsideTest(turned)) == 0);

  TriangleMesh open = sphere;  // without the cap above y = 0.9: a hole of 5 % of the directions
  std::erase_if(open.triangles, [&](const glm::uvec3& t) {
    return open.positions[t.x].y > 0.9f && open.positions[t.y].y > 0.9f &&
           open.positions[t.z].y > 0.9f;
  });
  CHECK(open.triangles.size() < sphere.triangles.size());
  const InsideTest inOpen(open);
  CHECK(inOpen.contains({0, 0, 0}));
  CHECK(inOpen.contains({0.3f, -0.5f, 0.6f}));
  CHECK_FALSE(inOpen.contains({0, 1.2f, 0}));
  CHECK_FALSE(inOpen.contains({0, -1.2f, 0}));

  const TriangleMesh smaller = transformed(sphere, glm::scale(glm::mat4(1), glm::vec3(0.5f)));
  CHECK(wrongSides(InsideTest(joined(sphere, smaller))) == 0);
}

TEST_CASE("the hash tells meshes apart") {
  const TriangleMesh sphere = icosphere(2);
  TriangleMesh other = sphere;
  CHECK(meshHash(sphere) == meshHash(other));
  other.positions[3].x = std::nextafter(other.positions[3].x, 2.0f);
  CHECK(meshHash(sphere) != meshHash(other));
  other = sphere;
  std::swap(other.triangles[0].x, other.triangles[0].y);
  CHECK(meshHash(sphere) != meshHash(other));
}
