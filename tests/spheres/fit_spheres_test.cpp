#include "spheres/fit_spheres.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "base/parallel.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "spheres/fit_shapes.h"
#include "spheres/silhouette_error.h"
#include "spheres/sphere_measures.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr auto cover = FitObjective::cover, shadow = FitObjective::shadow;

double coveredPart(const std::vector<glm::vec3>& points, const std::vector<Sphere>& spheres) {
  const auto covered = std::ranges::count_if(
      points, [&](const glm::vec3& point) { return isCovered(point, spheres); });
  return double(covered) / double(points.size());
}

/// Every vertex and triangle centre, and nearly all else of surface and inside.
void checkCovers(const SphereSet& set, const TriangleMesh& mesh) {
  CHECK(uncovered(mesh, set.spheres) == 0);
  CHECK(coveredPart(sampleSurface(mesh, 20000, 99), set.spheres) > 0.999);
  CHECK(coveredPart(sampleInterior(mesh, 10000, 99), set.spheres) > 0.9999);
}

/// The measures are those that other random numbers give.
void checkMeasures(const SphereSet& set, const TriangleMesh& mesh) {
  const SilhouetteError error = silhouetteError(mesh, set.spheres, {.seed = 77});
  CHECK(set.measures.silhouette->mean == doctest::Approx(error.mean).epsilon(0.04));
  CHECK(std::abs(set.measures.silhouette->under - error.under) < 0.04 * error.mean);
  const auto volumes = volumeMeasures(mesh, set.spheres, 200000, 77);
  CHECK(*set.measures.outsideVolumeRatio ==
        doctest::Approx(volumes->summedOutside).epsilon(0.03).scale(1));
  CHECK(*set.measures.unionOutsideRatio <= *set.measures.outsideVolumeRatio);
  CHECK(set.measures.coveredFraction ==
        doctest::Approx(coveredFraction(mesh, set.spheres, 50000, 77)).epsilon(0.01));
}

/// Both objectives with the same number of spheres, each better at what it makes small.
void checkObjectives(const TriangleMesh& mesh, std::size_t count) {
  const SphereSet covering = fitFor(cover, mesh, count).set;
  CHECK(covering.objective == cover);
  CHECK(covering.spheres.size() <= count);
  checkCovers(covering, mesh);
  checkMeasures(covering, mesh);
  const SphereSet shading = fitFor(shadow, mesh, count).set;
  CHECK(shading.objective == shadow);
  CHECK(shading.spheres.size() <= count);
  checkMeasures(shading, mesh);
  const SilhouetteError error = *shading.measures.silhouette;
  MESSAGE("silhouette errors: cover ", covering.measures.silhouette->mean, ", shadow ", error.mean,
          " (over ", error.over, ", under ", error.under, ")");
  CHECK(error.mean < covering.measures.silhouette->mean / 2);
  CHECK(error.over < 3 * error.under);
  CHECK(error.under < 3 * error.over);
}

/// The spheres of a mesh that was turned, scaled by `factor` and moved, where the mesh was before.
std::vector<Sphere> movedBack(std::vector<Sphere> spheres, const glm::mat4& matrix, float factor) {
  const glm::dmat4 back = glm::inverse(glm::dmat4(matrix));
  for (Sphere& sphere : spheres)
    sphere = {glm::vec3(back * glm::dvec4(sphere.center, 1)), sphere.radius / factor};
  return spheres;
}

/// A small body beside a larger one.
TriangleMesh twoBodies() {
  return combined(blob(2, 1), scaled(blob(3, 1), 0.5f, {3, 1, 0}));
}

/// With coordinates of so few binary digits that they can be moved without rounding.
TriangleMesh coarse(TriangleMesh mesh) {
  for (glm::vec3& position : mesh.positions) position = glm::round(position * 4096.0f) / 4096.0f;
  return mesh;
}

double outsideRatio(const TriangleMesh& mesh, const std::vector<Sphere>& spheres) {
  return volumeMeasures(mesh, spheres, 400000, 5)->summedOutside;
}

}  // namespace

TEST_CASE("32 spheres for a torus knot, to cover it and for its shadow") {
  checkObjectives(torusKnot(), 32);
}

TEST_CASE("32 spheres for a random blob, to cover it and for its shadow") {
  checkObjectives(blob(1, 3), 32);
}

TEST_CASE("neither threads nor powers of two change a digit of a fit") {
  const TriangleMesh mesh = twoBodies();
  for (const FitObjective objective : {cover, shadow}) {
    setThreadCount(1);
    const SphereSet set = fitFor(objective, mesh, 3).set;
    for (const int exponent : {-20, 20}) {
      const float factor = std::ldexp(1.0f, exponent);
      setThreadCount(exponent < 0 ? 2 : 3);
      SphereSet other = fitFor(objective, scaled(mesh, factor), 3).set;
      for (Sphere& sphere : other.spheres)
        sphere = {sphere.center / factor, sphere.radius / factor};
      checkSame(other.spheres, set.spheres);
      CHECK(other.measures.outsideVolumeRatio == set.measures.outsideVolumeRatio);
      CHECK(other.measures.silhouette->mean == set.measures.silhouette->mean);
    }
    setThreadCount(0);
  }
}

TEST_CASE("another seed gives other spheres that are as good") {
  const TriangleMesh mesh = blob(2, 2);
  const SphereSet set = fitFor(cover, mesh, 3).set, other = fitFor(cover, mesh, 3, 1).set;
  CHECK(set.seed == 0);
  CHECK(other.seed == 1);
  CHECK(other.spheres.front().center != set.spheres.front().center);
  CHECK(outsideRatio(mesh, other.spheres) ==
        doctest::Approx(outsideRatio(mesh, set.spheres)).epsilon(0.05));
}

TEST_CASE("a mesh that is moved without rounding takes its spheres along") {
  const TriangleMesh mesh = coarse(twoBodies());
  const glm::mat4 move = glm::translate(glm::mat4(1), glm::vec3(64, -128, 0.5f));
  for (const FitObjective objective : {cover, shadow}) {
    const std::vector<Sphere> spheres = fitFor(objective, mesh, 3).set.spheres;
    const std::vector<Sphere> moved =
        movedBack(fitFor(objective, transformed(mesh, move), 3).set.spheres, move, 1);
    REQUIRE(moved.size() == spheres.size());
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      CHECK(glm::distance(moved[i].center, spheres[i].center) < 3e-5f);
      CHECK(moved[i].radius == doctest::Approx(spheres[i].radius).epsilon(1e-4));
    }
  }
}

TEST_CASE("a mesh that is moved, turned and scaled is fitted as well") {
  const TriangleMesh pill = capsule(2, 3), bodies = twoBodies();
  const auto errorOf = [&](const std::vector<Sphere>& spheres) {
    return silhouetteError(bodies, spheres).mean;
  };
  const double outside = outsideRatio(pill, fitFor(cover, pill, 2).set.spheres);
  const double error = errorOf(fitFor(shadow, bodies, 2).set.spheres);
  for (const float factor : {0.3f, 1.4f}) {
    const glm::mat4 scale = glm::scale(glm::mat4(1), glm::vec3(factor));
    const glm::mat4 turn = glm::rotate(scale, 2 + factor, glm::vec3(1, -2, 0.5f));
    const glm::mat4 move = glm::translate(glm::mat4(1), factor * glm::vec3(1, 2, -3)) * turn;
    const auto fitted = [&](FitObjective objective, const TriangleMesh& mesh) {
      return movedBack(fitFor(objective, transformed(mesh, move), 2).set.spheres, move, factor);
    };
    CHECK(outsideRatio(pill, fitted(cover, pill)) == doctest::Approx(outside).epsilon(0.01));
    CHECK(errorOf(fitted(shadow, bodies)) == doctest::Approx(error).epsilon(0.01));
  }
}

TEST_CASE("64 spheres for the Stanford bunny") {
  const auto path = testData("meshes/bunny.obj");
  if (!path) return;
  const TriangleMesh bunny = loadMesh(*path).mesh;
  const SphereSet covering = fitFor(cover, bunny, 64).set;
  CHECK(covering.spheres.size() <= 64);
  CHECK(uncovered(bunny, covering.spheres) == 0);
  CHECK(covering.measures.coveredFraction > 0.999);
  CHECK(*covering.measures.outsideVolumeRatio < 0.30);
  CHECK(fitFor(shadow, bunny, 64).set.measures.silhouette->mean < 0.045);
}

TEST_CASE("64 spheres for the armadillo") {
  const auto path = testData("meshes/armadillo.obj");
  if (!path) return;
  CHECK(fitFor(shadow, loadMesh(*path).mesh, 64).set.measures.silhouette->mean < 0.07);
}
