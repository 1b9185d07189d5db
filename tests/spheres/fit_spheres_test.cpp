#include "spheres/fit_spheres.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "test_support.h"

using namespace haarlight;

namespace {

bool isCovered(const glm::vec3& point, const std::vector<Sphere>& spheres) {
  return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
    return glm::distance(point, sphere.center) <= sphere.radius;
  });
}

/// Number of used vertices and triangle centres outside all spheres, in float.
int uncovered(const TriangleMesh& mesh, const std::vector<Sphere>& spheres) {
  int count = 0;
  for (const auto& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    for (const glm::vec3& point : {a, b, c, (a + b + c) / 3.0f})
      count += !isCovered(point, spheres);
  }
  return count;
}

TriangleMesh scaled(const TriangleMesh& mesh, float factor, const glm::vec3& offset = {}) {
  return transformed(mesh, glm::scale(glm::translate(glm::mat4(1), offset), glm::vec3(factor)));
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  for (const auto& t : b.triangles) a.triangles.push_back(t + offset);
  return a;
}

void checkSame(const SphereSet& a, const SphereSet& b) {
  REQUIRE(a.spheres.size() == b.spheres.size());
  for (std::size_t i = 0; i < a.spheres.size(); ++i) {
    CHECK(a.spheres[i].center == b.spheres[i].center);
    CHECK(a.spheres[i].radius == b.spheres[i].radius);
  }
}

}  // namespace

TEST_CASE("one sphere around a fine sphere is that sphere") {
  const TriangleMesh sphere = scaled(icosphere(4), 2, {1, 2, 3});
  const SphereSet set = fitSpheres(sphere, 1);
  REQUIRE(set.spheres.size() == 1);
  CHECK(glm::distance(set.spheres[0].center, glm::vec3(1, 2, 3)) < 2e-3f);
  CHECK(set.spheres[0].radius == doctest::Approx(2).epsilon(1e-3));
  // The volume between the triangles and the sphere: E = V(sphere) / V(mesh) - 1 = 0.00217.
  const double ratio = 4.0 / 3 * 3.14159265 * 8 / signedVolume(sphere) - 1;
  CHECK(*set.measures.outsideVolumeRatio == doctest::Approx(ratio).epsilon(0.5));
  CHECK(set.measures.coveredFraction == 1);
  CHECK(set.meshHash == meshHash(sphere));
  // More spheres cannot do better than the one.
  CHECK(fitSpheres(sphere, 5).spheres.size() == 1);
}

TEST_CASE("two spheres far from each other are found") {
  const TriangleMesh pair =
      joined(scaled(icosphere(3), 1, {-5, 0, 0}), scaled(icosphere(3), 0.5f, {5, 1, 0}));
  SphereSet set = fitSpheres(pair, 2);
  REQUIRE(set.spheres.size() == 2);
  if (set.spheres[0].center.x > 0) std::swap(set.spheres[0], set.spheres[1]);
  CHECK(glm::distance(set.spheres[0].center, glm::vec3(-5, 0, 0)) < 0.01f);
  CHECK(glm::distance(set.spheres[1].center, glm::vec3(5, 1, 0)) < 0.01f);
  CHECK(set.spheres[0].radius == doctest::Approx(1).epsilon(0.01));
  CHECK(set.spheres[1].radius == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("every vertex and triangle centre is covered, and more spheres fit tighter") {
  const TriangleMesh knot = torusKnot();
  double last = std::numeric_limits<double>::infinity();
  for (const std::size_t count : {1, 16, 64}) {
    const SphereSet set = fitSpheres(knot, count);
    CHECK(set.spheres.size() <= count);
    CHECK(uncovered(knot, set.spheres) == 0);
    CHECK(set.measures.coveredFraction > 0.998);
    CHECK(*set.measures.outsideVolumeRatio < last);
    last = *set.measures.outsideVolumeRatio;
  }
}

TEST_CASE("surfaces without an inside: one triangle, a flat grid, an open bowl") {
  const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}};
  for (const std::size_t count : {1, 7, 200}) {
    const SphereSet set = fitSpheres(triangle, count);
    CHECK(set.spheres.size() <= count);
    CHECK(set.spheres.size() >= std::min<std::size_t>(count, 190));
    CHECK(uncovered(triangle, set.spheres) == 0);
    CHECK_FALSE(set.measures.outsideVolumeRatio);
  }
  // The smallest ball around a right triangle has its longest edge as diameter.
  CHECK(fitSpheres(triangle, 1).spheres[0].radius == doctest::Approx(std::sqrt(0.5)).epsilon(1e-3));

  const TriangleMesh grid = groundGrid(1, 8);
  const SphereSet set = fitSpheres(grid, 16);
  CHECK(uncovered(grid, set.spheres) == 0);
  // 16 balls can cover the square in a 4 × 4 pattern with the radius √2 / 4 each.
  double volume = 0;
  for (const Sphere& sphere : set.spheres) volume += std::pow(sphere.radius, 3);
  CHECK(volume < 16 * std::pow(std::sqrt(2.0) / 4, 3) * 1.25);

  TriangleMesh bowl = icosphere(3);
  std::erase_if(bowl.triangles, [&](const auto& t) { return bowl.positions[t.x].y > 0; });
  CHECK(uncovered(bowl, fitSpheres(bowl, 20).spheres) == 0);
}

TEST_CASE("the same at any scale and place, from any number of threads") {
  const TriangleMesh knot = torusKnot({.lengthSegments = 64, .tubeSegments = 8});
  const SphereSet set = fitSpheres(knot, 10);
  setThreadCount(1);
  const SphereSet single = fitSpheres(knot, 10);
  setThreadCount(5);
  const SphereSet five = fitSpheres(knot, 10);
  setThreadCount(0);
  checkSame(set, single);
  checkSame(set, five);
  CHECK(*set.measures.outsideVolumeRatio == *single.measures.outsideVolumeRatio);

  // A power of two changes no digit: then the spheres are the same to the last bit, but for the
  // rounding of the denormal range, which is not reached.
  for (const float factor : {0x1p-20f, 0x1p20f}) {
    SphereSet other = fitSpheres(scaled(knot, factor), 10);
    for (Sphere& sphere : other.spheres) {
      sphere.center /= factor;
      sphere.radius /= factor;
    }
    checkSame(set, other);
  }
  // Otherwise coordinates are rounded, and the search may end elsewhere; it is as good.
  for (const float factor : {1e-6f, 1e6f}) {
    const TriangleMesh other = scaled(knot, factor, glm::vec3(2 * factor));
    const SphereSet otherSet = fitSpheres(other, 10);
    CHECK(uncovered(other, otherSet.spheres) == 0);
    CHECK(*otherSet.measures.outsideVolumeRatio ==
          doctest::Approx(*set.measures.outsideVolumeRatio).epsilon(0.15));
  }
}

TEST_CASE("progress reaches the end in ascending steps") {
  std::vector<double> steps;
  SphereFitOptions options;
  options.progress = [&](double part) { steps.push_back(part); };
  fitSpheres(icosphere(2), 2, options);
  REQUIRE_FALSE(steps.empty());
  CHECK(std::is_sorted(steps.begin(), steps.end()));
  CHECK(steps.back() == 1);
}

TEST_CASE("requests that make no sense are refused") {
  CHECK_THROWS_AS(fitSpheres(icosphere(1), 0), InputError);
  CHECK_THROWS_AS(fitSpheres(icosphere(1), maximumSphereCount + 1), InputError);
  CHECK_THROWS_AS(fitSpheres(TriangleMesh{}, 4), InputError);
}

TEST_CASE("64 spheres for the Stanford bunny") {
  const auto path = test::testData("meshes/bunny.obj");
  if (!path) return;
  const TriangleMesh bunny = loadMesh(*path).mesh;
  const SphereSet set = fitSpheres(bunny, 64);
  CHECK(set.spheres.size() <= 64);
  CHECK(uncovered(bunny, set.spheres) == 0);
  CHECK(set.measures.coveredFraction > 0.999);
  CHECK(*set.measures.outsideVolumeRatio < 0.32);
}
