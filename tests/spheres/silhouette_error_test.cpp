#include "spheres/silhouette_error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "mesh/test_meshes.h"
#include "spheres/random_spheres.h"
#include "spheres/viewpoints.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// All viewpoints at a distance from the middle of the mesh's box.
SilhouetteSampling fromDistance(const TriangleMesh& mesh, double distance) {
  const BoundingBox box = boundingBox(mesh);
  const double multiple =
      2 * distance / glm::distance(glm::dvec3(box.lower), glm::dvec3(box.upper));
  return {.viewpoints = 40, .range = {multiple, multiple}};
}

/// Of a ball, as part of the half sphere.
double solidAngle(double radius, double distance) {
  return 1 - std::sqrt(1 - radius * radius / (distance * distance));
}

bool blocks(const std::vector<Sphere>& spheres, const glm::dvec3& from, const glm::dvec3& towards) {
  return std::ranges::any_of(spheres, [&](const Sphere& sphere) {
    const glm::dvec3 offset = glm::dvec3(sphere.center) - from;
    return glm::dot(offset, towards) > 0 &&
           glm::length(glm::cross(offset, towards)) < sphere.radius;
  });
}

/// The error of one set of spheres for another from random viewpoints and rays; both must lie in
/// the ball of radius `extent` around the origin.
SilhouetteError errorByChance(const std::vector<Sphere>& truth, const std::vector<Sphere>& spheres,
                              double nearest, double farthest, double extent) {
  Random random(9);
  SilhouetteError error;
  constexpr int viewpoints = 1000, rays = 400;
  for (int i = 0; i < viewpoints; ++i) {
    const double distance = nearest + (farthest - nearest) * random.uniform();
    const glm::dvec3 eye = distance * randomDirection(random);
    int seen = 0, over = 0, under = 0;
    const glm::dmat3 basis = basisAround(-eye / distance);
    for (int ray = 0; ray < rays; ++ray) {
      const double z = 1 - solidAngle(extent, distance) * random.uniform();
      const double flat = std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * random.uniform();
      const glm::dvec3 direction =
          basis * glm::dvec3(flat * std::cos(angle), flat * std::sin(angle), z);
      const bool isTrue = blocks(truth, eye, direction), isBall = blocks(spheres, eye, direction);
      seen += isTrue;
      over += isBall && !isTrue;
      under += isTrue && !isBall;
    }
    error.over += double(over) / seen / viewpoints;
    error.under += double(under) / seen / viewpoints;
  }
  error.mean = error.over + error.under;
  return error;
}

}  // namespace

TEST_CASE("silhouette errors of balls around and within a sphere are ratios of solid angles") {
  const TriangleMesh sphere = icosphere(5);
  for (const double distance : {2.0, 5.0})
    for (const float size : {0.5f, 0.9f, 1.0f, 1.2f, 1.7f}) {
      const std::vector<Sphere> spheres = {{{0, 0, 0}, size}};
      const SilhouetteError error =
          silhouetteError(sphere, spheres, fromDistance(sphere, distance));
      const double change = solidAngle(size, distance) / solidAngle(1, distance) - 1;
      CHECK(std::abs(error.over - std::max(change, 0.0)) < 0.01 + 0.01 * std::abs(change));
      CHECK(std::abs(error.under - std::max(-change, 0.0)) < 0.01);
      CHECK(error.mean == error.over + error.under);
      CHECK(error.worst >= error.mean);
      CHECK(error.worst < error.mean + 0.02 + 0.02 * std::abs(change));
    }
}

TEST_CASE("without spheres all of the mesh is missing, and a sphere around the eye blocks all") {
  const TriangleMesh sphere = icosphere(4);
  for (const TriangleMesh& mesh : {sphere, torusKnot(), groundGrid(1, 4)}) {
    const SilhouetteError none = silhouetteError(mesh, {});
    CHECK(none.mean == 1);
    CHECK(none.worst == 1);
    CHECK(none.under == 1);
    CHECK(none.over == 0);
  }
  SilhouetteSampling sampling = fromDistance(sphere, 1.8);
  sampling.raysPerViewpoint = 20000;
  const std::vector<Sphere> huge = {{{0, 0, 0}, 10}};
  const SilhouetteError all = silhouetteError(sphere, huge, sampling);
  CHECK(all.over == doctest::Approx(2 / solidAngle(1, 1.8) - 1).epsilon(0.02));
  CHECK(all.under == 0);
}

TEST_CASE("no mesh has no silhouette error") {
  const SilhouetteError error = silhouetteError({}, std::vector<Sphere>{{{0, 0, 0}, 1}});
  CHECK(error.mean == 0);
  CHECK(error.worst == 0);
}

TEST_CASE("silhouette errors are those of random rays from random viewpoints") {
  const std::vector<Sphere> truth = {{{-0.7f, 0, 0}, 0.3f}, {{0.6f, 0.2f, 0}, 0.4f}};
  const std::vector<Sphere> spheres = {
      {{-0.6f, 0.1f, 0}, 0.4f}, {{0.6f, 0.2f, 0.3f}, 0.3f}, {{0, -0.7f, 0}, 0.1f}};
  TriangleMesh mesh = combined(sphereAt(truth[0].center, truth[0].radius, 5),
                               sphereAt(truth[1].center, truth[1].radius, 5));
  // A box around the origin, by two specks in its corners that hardly block anything.
  const BoundingBox box{{-1, -1, -1}, {1, 1, 1}};
  for (const glm::vec3& corner : {box.lower, box.upper})
    mesh = combined(mesh, sphereAt(corner * 0.999f, 0.001f, 0));
  const double half = std::sqrt(3.0);
  const ViewpointRange range{1.2, 3};
  const SilhouetteError error = silhouetteError(mesh, spheres, {.viewpoints = 400, .range = range});
  const SilhouetteError expected =
      errorByChance(truth, spheres, range.nearest * half, range.farthest * half, 1.05);
  CHECK(std::abs(error.over / expected.over - 1) < 0.03);
  CHECK(std::abs(error.under / expected.under - 1) < 0.03);
  CHECK(std::abs(error.mean / expected.mean - 1) < 0.03);
}

TEST_CASE("silhouette errors do not depend on scale, place or the number of threads") {
  const TriangleMesh knot = torusKnot();
  std::vector<Sphere> spheres = randomSpheres(20, 3);
  const SilhouetteSampling sampling{.viewpoints = 30, .raysPerViewpoint = 1000, .seed = 4};
  const SilhouetteError error = silhouetteError(knot, spheres, sampling);
  CHECK(error.over > 0.01);
  CHECK(error.under > 0.01);
  const auto same = [](const SilhouetteError& a, const SilhouetteError& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
  };
  setThreadCount(1);
  CHECK(same(silhouetteError(knot, spheres, sampling), error));
  setThreadCount(3);
  CHECK(same(silhouetteError(knot, spheres, sampling), error));
  setThreadCount(0);

  const glm::mat4 scale = glm::scale(glm::mat4(1), glm::vec3(0x1p20f));
  for (Sphere& sphere : spheres) sphere = {sphere.center * 0x1p20f, sphere.radius * 0x1p20f};
  CHECK(same(silhouetteError(transformed(knot, scale), spheres, sampling), error));
  const glm::vec3 offset(0x1p20f, -0x1p21f, 0);
  const glm::mat4 move = glm::translate(glm::mat4(1), offset);
  for (Sphere& sphere : spheres) sphere.center += offset;
  const SilhouetteError moved = silhouetteError(transformed(knot, move * scale), spheres, sampling);
  CHECK(std::abs(moved.mean / error.mean - 1) < 0.001);
}

TEST_CASE("the mean silhouette error hardly depends on the seed") {
  const TriangleMesh knot = torusKnot();
  const std::vector<Sphere> spheres = randomSpheres(20, 3);
  const double one = silhouetteError(knot, spheres, {.seed = 1}).mean;
  const double two = silhouetteError(knot, spheres, {.seed = 2}).mean;
  CHECK(one != two);
  CHECK(std::abs(two / one - 1) < 0.03);
}
