#include "spheres/sphere_measures.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "spheres/solid_grid.h"

using namespace haarlight;

namespace {

TriangleMesh unitCube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  mesh.normals.assign(8, glm::vec3(0, 1, 0));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

double ballVolume(double radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

}  // namespace

TEST_CASE("the outside volume of balls at a cube") {
  const TriangleMesh cube = unitCube();
  REQUIRE(signedVolume(cube) == doctest::Approx(1));
  // Inside, outside, halved by a face, a quarter and an eighth inside at an edge and a corner.
  const struct {
    glm::vec3 center;
    double outsidePart;
  } cases[] = {{{0.5f, 0.5f, 0.5f}, 0},
               {{2, 0, 0}, 1},
               {{1, 0.5f, 0.5f}, 0.5},
               {{1, 1, 0.5f}, 0.75},
               {{1, 1, 1}, 0.875}};
  const SolidGrid grid(cube, 64);
  CHECK(grid.volume() == doctest::Approx(1).epsilon(1e-6));
  for (const auto& one : cases) {
    const std::vector<Sphere> spheres = {{one.center, 0.3f}};
    const double expected = ballVolume(0.3f) * one.outsidePart;
    const double error =
        ballVolume(0.3f) * std::sqrt(one.outsidePart * (1 - one.outsidePart) / 1e5);
    CHECK(std::abs(*outsideVolumeRatio(cube, spheres, 100000, 1) - expected) <= 5 * error + 1e-12);
    CHECK(std::abs(grid.outsideVolume({one.center, 0.3f}) - expected) < 0.01 * ballVolume(0.3f));
  }
}

TEST_CASE("overlapping spheres count once each") {
  const TriangleMesh cube = unitCube();
  const std::vector<Sphere> spheres(3, Sphere{{3, 3, 3}, 0.5f});
  CHECK(*outsideVolumeRatio(cube, spheres, 3000, 1) == doctest::Approx(3 * ballVolume(0.5)));
}

TEST_CASE("a ball between the rows of a grid is inside or outside") {
  const SolidGrid grid(unitCube(), 8);
  CHECK(grid.outsideVolume({{0.5 + 0.01, 0.5 + 0.01, 0.5 + 0.01}, 1e-3}) == 0);
  CHECK(grid.outsideVolume({{2, 2, 2}, 1e-3}) == doctest::Approx(ballVolume(1e-3)));
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
}

TEST_CASE("measures: no volume, holes, several parts, any scale, any number of threads") {
  const std::vector<Sphere> spheres = {{{0, 0, 0}, 1}};
  CHECK_FALSE(outsideVolumeRatio(groundGrid(1, 4), spheres, 10000, 1));
  CHECK_FALSE(outsideVolumeRatio(TriangleMesh{}, spheres, 10000, 1));

  TriangleMesh open = unitCube();
  open.triangles.resize(open.triangles.size() - 1);  // half a face of twelve
  const std::vector<Sphere> outside = {{{5, 5, 5}, 1}};
  CHECK(*outsideVolumeRatio(open, outside, 40000, 1) ==
        doctest::Approx(ballVolume(1)).epsilon(0.05));

  const TriangleMesh knot = torusKnot();
  const double ratio = *outsideVolumeRatio(knot, spheres, 20000, 1);
  CHECK(ratio == doctest::Approx(ballVolume(1) / signedVolume(knot) - 1).epsilon(0.02));
  setThreadCount(1);
  CHECK(*outsideVolumeRatio(knot, spheres, 20000, 1) == ratio);
  setThreadCount(0);
  const TriangleMesh tiny = transformed(knot, glm::scale(glm::mat4(1), glm::vec3(0x1p-20f)));
  CHECK(*outsideVolumeRatio(tiny, std::vector<Sphere>{{{0, 0, 0}, 0x1p-20f}}, 20000, 1) == ratio);
}
