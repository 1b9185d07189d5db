#include "spheres/sphere_measures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "mesh/test_meshes.h"
#include "spheres/silhouette_error.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr std::size_t samples = 100000;

TriangleMesh unitCube() {
  return box(glm::vec3(0), glm::vec3(1));
}

VolumeMeasures volumesAt(const TriangleMesh& mesh, const std::vector<Sphere>& spheres,
                         std::size_t count = samples) {
  const auto volumes = volumeMeasures(mesh, spheres, count, 1);
  REQUIRE(volumes);
  return *volumes;
}

double ballVolume(double radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

/// Five standard errors of a part of a volume found by random points in it.
double tolerance(double volume, double part) {
  return 5 * volume * std::sqrt(part * (1 - part) / samples) + 1e-6;
}

}  // namespace

TEST_CASE("volumes of a ball at a cube, outside and uncovered") {
  // Inside, outside, halved by a face, a quarter and an eighth inside at an edge and a corner.
  const struct {
    glm::vec3 center;
    double outsidePart;
  } cases[] = {{{0.5f, 0.5f, 0.5f}, 0},
               {{2, 0, 0}, 1},
               {{1, 0.5f, 0.5f}, 0.5},
               {{1, 1, 0.5f}, 0.75},
               {{1, 1, 1}, 0.875}};
  for (const auto& one : cases) {
    const VolumeMeasures volumes = volumesAt(unitCube(), {{one.center, 0.4f}});
    const double ball = ballVolume(0.4f), inside = ball * (1 - one.outsidePart);
    const double error = tolerance(ball, one.outsidePart);
    CHECK(std::abs(volumes.summedOutside - ball * one.outsidePart) < error);
    CHECK(std::abs(volumes.unionOutside - ball * one.outsidePart) < error);
    CHECK(std::abs(volumes.uncovered - (1 - inside)) < tolerance(1, inside));
  }
}

TEST_CASE("estimates of volumes scatter as those of independent points") {
  // Half of the ball lies in the cube.
  const std::vector<Sphere> spheres = {{{1, 0.5f, 0.5f}, 0.4f}};
  const double half = ballVolume(0.4f) / 2;
  constexpr int seeds = 30, count = 20000;
  double outside = 0, uncovered = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const auto volumes = volumeMeasures(unitCube(), spheres, count, seed);
    outside += std::pow(volumes->summedOutside - half, 2) / seeds;
    uncovered += std::pow(volumes->uncovered - (1 - half), 2) / seeds;
  }
  // Three standard deviations of the mean of 30 squares are 3 √(2/30) of it.
  CHECK(std::abs(uncovered / (half * (1 - half) / count) - 1) < 0.77);
  CHECK(std::abs(outside / (half * half / count) - 1) < 0.77);
}

TEST_CASE("the summed volume counts overlaps once per sphere, the union once") {
  const std::vector<Sphere> same(3, Sphere{{3, 3, 3}, 0.5f});
  CHECK(volumesAt(unitCube(), same).summedOutside == doctest::Approx(3 * ballVolume(0.5)));
  CHECK(volumesAt(unitCube(), same).unionOutside == doctest::Approx(ballVolume(0.5)));
  CHECK(volumesAt(unitCube(), same).uncovered == 1);

  // Two unit balls at a distance d share a lens of volume π (4 + d) (2 - d)² / 12.
  const double d = 0.8, lens = std::numbers::pi * (4 + d) * (2 - d) * (2 - d) / 12;
  const std::vector<Sphere> pair = {{{5, 0, 0}, 1}, {{5, float(d), 0}, 1}};
  const VolumeMeasures volumes = volumesAt(unitCube(), pair);
  CHECK(volumes.summedOutside == doctest::Approx(2 * ballVolume(1)).epsilon(1e-6));
  // Of the points in the two balls, those in the lens count a half.
  const double part = lens / ballVolume(1);
  CHECK(std::abs(volumes.unionOutside - (2 * ballVolume(1) - lens)) <
        tolerance(ballVolume(1), part));
}

TEST_CASE("volumes are parts of the mesh's, at any scale and for any number of threads") {
  const TriangleMesh knot = torusKnot({.lengthSegments = 64, .tubeSegments = 12});
  const std::vector<Sphere> around = {{{0, 0, 0}, 1}};
  constexpr std::size_t count = 20000;
  const VolumeMeasures volumes = volumesAt(knot, around, count);
  const double expected = ballVolume(1) / signedVolume(knot) - 1;
  CHECK(volumes.summedOutside == doctest::Approx(expected).epsilon(0.02));
  CHECK(volumes.unionOutside == volumes.summedOutside);
  CHECK(volumes.uncovered == doctest::Approx(0).epsilon(1e-4));
  const auto isSame = [&](const VolumeMeasures& other) {
    return other.summedOutside == volumes.summedOutside &&
           other.unionOutside == volumes.unionOutside && other.uncovered == volumes.uncovered;
  };
  setThreadCount(1);
  CHECK(isSame(volumesAt(knot, around, count)));
  setThreadCount(3);
  CHECK(isSame(volumesAt(knot, around, count)));
  setThreadCount(0);
  const TriangleMesh tiny = transformed(knot, glm::scale(glm::mat4(1), glm::vec3(0x1p-20f)));
  CHECK(isSame(volumesAt(tiny, {{{0, 0, 0}, 0x1p-20f}}, count)));
}

TEST_CASE("volumes of meshes without, with a hole, of several parts") {
  const std::vector<Sphere> unit = {{{0, 0, 0}, 1}};
  CHECK_FALSE(volumeMeasures(groundGrid(1, 4), unit, samples, 1));
  CHECK_FALSE(volumeMeasures(TriangleMesh{}, unit, samples, 1));
  CHECK_FALSE(volumeMeasures(unitCube(), unit, 0, 1));

  TriangleMesh open = unitCube();
  open.triangles.pop_back();  // half a face of six
  CHECK(volumesAt(open, {{{5, 5, 5}, 1}}).summedOutside ==
        doctest::Approx(ballVolume(1)).epsilon(0.05));

  // Two overlapping cubes count as their union, of volume 1.5.
  const TriangleMesh two = combined(unitCube(), box(glm::vec3(0.5f, 0, 0), glm::vec3(1.5f, 1, 1)));
  const VolumeMeasures volumes = volumesAt(two, {{{0.75f, 0.5f, 0.5f}, 0.5f}, {{5, 5, 5}, 1}});
  CHECK(volumes.summedOutside == doctest::Approx(ballVolume(1) / 1.5).epsilon(0.01));
  CHECK(std::abs(volumes.uncovered - (1 - ballVolume(0.5) / 1.5)) < 0.01);
}

TEST_CASE("the covered part of a sphere's surface is that of a cap") {
  // A ball of radius 1 around a point at distance d from the centre of the unit sphere covers the
  // cap where the height along d is at least d / 2: the part (1 - d / 2) / 2.
  const TriangleMesh sphere = icosphere(5);
  for (const float d : {0.25f, 0.5f, 1.0f}) {
    const std::vector<Sphere> spheres = {{{0, d, 0}, 1}};
    const double part = (1 - d / 2) / 2;
    const double error = std::sqrt(part * (1 - part) / 40000);
    CHECK(std::abs(coveredFraction(sphere, spheres, 40000, 1) - part) < 5 * error + 2e-3);
  }
  CHECK(coveredFraction(sphere, {}, 1000, 1) == 0);
  CHECK(coveredFraction({}, std::vector<Sphere>{{{0, 0, 0}, 1}}, 1000, 1) == 0);
}

TEST_CASE("all measures of spheres together") {
  const TriangleMesh cube = unitCube();
  const std::vector<Sphere> spheres = {{{0.5f, 0.5f, 0.5f}, 0.7f}};
  const SphereMeasures measures = measureSpheres(cube, spheres, 20000, 3);
  // The ball covers a disc on each face.
  CHECK(std::abs(measures.coveredFraction - std::numbers::pi * (0.7 * 0.7 - 0.25)) < 0.015);
  const VolumeMeasures volumes = *volumeMeasures(cube, spheres, 20000, 3);
  CHECK(measures.outsideVolumeRatio == volumes.summedOutside);
  CHECK(measures.unionOutsideRatio == volumes.unionOutside);
  CHECK(measures.uncoveredVolumeRatio == volumes.uncovered);
  REQUIRE(measures.silhouette);
  CHECK(measures.silhouette->mean == silhouetteError(cube, spheres, {.seed = 3}).mean);

  const SphereMeasures sheet = measureSpheres(groundGrid(1, 4), spheres, 2000);
  CHECK_FALSE(sheet.outsideVolumeRatio);
  CHECK_FALSE(sheet.unionOutsideRatio);
  CHECK_FALSE(sheet.uncoveredVolumeRatio);
  CHECK(sheet.silhouette);
}
