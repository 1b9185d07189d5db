#include "spheres/solid_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/test_meshes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

TriangleMesh unitCube() {
  return box(glm::vec3(0), glm::vec3(1));
}

double ballVolume(double radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

int topLevel(const SolidGrid& grid) {
  return grid.levelFor(std::numeric_limits<double>::infinity(), 1);
}

/// A part of a cube's volume, from points in the middle of 64³ cells of it.
template <typename Inside>
double volumeByCells(const glm::dvec3& lower, double side, const Inside& inside) {
  constexpr int cells = 64;
  int count = 0;
  for (int z = 0; z < cells; ++z)
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x)
        count += inside(lower + (glm::dvec3(x, y, z) + 0.5) * (side / cells));
  return count * std::pow(side / cells, 3);
}

}  // namespace

TEST_CASE("the outside volume of balls at a cube, on all levels of a grid") {
  // Inside, outside, halved by a face, a quarter and an eighth inside at an edge and a corner.
  const struct {
    glm::dvec3 center;
    double outsidePart;
  } cases[] = {{{0.5, 0.5, 0.5}, 0},
               {{2, 0, 0}, 1},
               {{1, 0.5, 0.5}, 0.5},
               {{1, 1, 0.5}, 0.75},
               {{1, 1, 1}, 0.875}};
  const SolidGrid grid(unitCube(), 64);
  REQUIRE(topLevel(grid) == 3);
  // Cells of 1/64 … 1/8, whose boundaries are the cube's.
  const double tolerances[] = {0.002, 0.004, 0.01, 0.02};
  for (const auto& one : cases)
    for (int level = 0; level <= 3; ++level)
      CHECK(std::abs(grid.outsideVolume({one.center, 0.3}, level) -
                     ballVolume(0.3) * one.outsidePart) < tolerances[level] * ballVolume(0.3));
}

TEST_CASE("a ball around the whole solid has its own volume less the solid's outside") {
  // Sides of 21, 15 and 7 cells: odd on several levels.
  const TriangleMesh odd = box({0, 0, 0}, {2.1f, 1.5f, 0.7f});
  const TriangleMesh knot = torusKnot();
  for (const TriangleMesh& mesh : {odd, knot}) {
    const SolidGrid grid(mesh, 21);
    const BoundingBox bounds = boundingBox(mesh);
    const glm::dvec3 center = (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper)) / 2.0;
    REQUIRE(topLevel(grid) == 2);
    for (int level = 0; level <= 2; ++level) {
      const double inside = ballVolume(2) - grid.outsideVolume({center, 2}, level);
      CHECK(std::abs(inside / grid.volume() - 1) < 0.01);
    }
  }
  CHECK(SolidGrid(odd, 21).volume() == doctest::Approx(signedVolume(odd)).epsilon(1e-5));
}

TEST_CASE("the outside volume of balls at a sphere is that of a sum over points") {
  const SolidGrid grid(sphereAt({1, 2, 3}, 1, 5), 96);
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 offset(random.uniform(), random.uniform(), random.uniform());
    const Ball ball{glm::dvec3(1, 2, 3) + 1.6 * offset - 0.8, 0.1 + 0.5 * random.uniform()};
    const double expected =
        volumeByCells(ball.center - ball.radius, 2 * ball.radius, [&](const glm::dvec3& point) {
          return glm::distance(point, ball.center) < ball.radius &&
                 glm::distance(point, glm::dvec3(1, 2, 3)) > 1;
        });
    // A surface that is off by 1/20 of a cell over the ball's disc.
    const double cell = 2.0 / 96;
    for (int level = 0; level <= topLevel(grid); ++level) {
      const double disc = std::numbers::pi * ball.radius * ball.radius;
      const double size = cell * std::exp2(level);
      if (ball.radius < 3 * size) break;
      CHECK(std::abs(grid.outsideVolume(ball, level) - expected) < size * disc / 10);
    }
  }
}

TEST_CASE("the level for a ball is the coarsest with cells fine enough") {
  const SolidGrid grid(unitCube(), 100);  // levels of 100, 50, 25, 13 and 7 cells
  CHECK(topLevel(grid) == 4);
  for (const double cells : {1.0, 5.0, 12.0})
    for (int level = 0; level <= 4; ++level) {
      const double enough = cells * 0.01 * std::exp2(level);
      CHECK(grid.levelFor(enough * 1.001, cells) == level);
      CHECK(grid.levelFor(enough * 1.999, cells) == level);
      CHECK(grid.levelFor(enough * 0.999, cells) == std::max(level - 1, 0));
    }
  CHECK(grid.levelFor(0, 5) == 0);
  CHECK(topLevel(SolidGrid(unitCube(), 8)) == 0);
}

TEST_CASE("a ball between the rows of a grid is inside or outside") {
  const SolidGrid grid(unitCube(), 8);
  CHECK(grid.outsideVolume({{0.5 + 0.01, 0.5 + 0.01, 0.5 + 0.01}, 1e-3}) == 0);
  CHECK(grid.outsideVolume({{2, 2, 2}, 1e-3}) / ballVolume(1e-3) == doctest::Approx(1));
  CHECK(grid.outsideVolume({{0.5, 0.5, 0.5}, 0}) == 0);
}

TEST_CASE("the volume of a grid is the mesh's") {
  const auto check = [](const TriangleMesh& mesh, double volume, double epsilon = 0.01) {
    CHECK(std::abs(SolidGrid(mesh, 64).volume() / volume - 1) < epsilon);
  };
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 1, 4), knot = torusKnot();
  check(sphere, signedVolume(sphere));
  check(turnedOver(sphere), signedVolume(sphere));
  check(knot, signedVolume(knot), 0.02);
  check(sphereAt({1000, -2000, 500}, 100, 4), signedVolume(sphere) * 1e6);
  // Overlapping parts count once: the lens of two unit balls at a distance of 1 is 5π / 12.
  check(combined(sphere, sphereAt({1, 0, 0}, 1, 4)), 2 * ballVolume(1) - 5 * std::numbers::pi / 12);
  // A shell that faces inwards is a cavity.
  check(combined(sphere, turnedOver(sphereAt({0, 0, 0}, 0.5f, 4))),
        ballVolume(1) - ballVolume(0.5));
  CHECK(SolidGrid(groundGrid(1, 4), 64).volume() == 0);
}

TEST_CASE("a mesh with holes still has an inside") {
  TriangleMesh cube = unitCube();
  cube.triangles.pop_back();
  CHECK(SolidGrid(cube, 32).volume() == doctest::Approx(1).epsilon(0.01));
  cube.triangles.pop_back();  // a whole face
  CHECK(SolidGrid(cube, 32).volume() == doctest::Approx(1).epsilon(0.01));

  TriangleMesh sphere = icosphere(4);
  const double whole = SolidGrid(sphere, 48).volume();
  std::erase_if(sphere.triangles, [&](const glm::uvec3& t) {
    const glm::vec3& p = sphere.positions[t.x];
    return p.y > 0.97f || glm::distance(p, glm::vec3(0, 0.6f, 0.8f)) < 0.2f;
  });
  CHECK(SolidGrid(sphere, 48).volume() == doctest::Approx(whole).epsilon(0.01));
}

TEST_CASE("points of a grid lie inside and are spread evenly") {
  const SolidGrid grid(sphereAt({0, 0, 0}, 1, 4), 40);
  for (const std::size_t count : {1, 50, 3000}) {
    const std::vector<glm::vec3> points = grid.insidePoints(count);
    CHECK(points.size() <= count);
    CHECK(points.size() + 1 >= count);
    for (const glm::vec3& point : points) CHECK(glm::length(point) < 1);
  }
  glm::dvec3 mean(0);
  std::size_t octants[8] = {};
  const std::vector<glm::vec3> points = grid.insidePoints(4000);
  for (const glm::vec3& point : points) {
    mean += glm::dvec3(point) / double(points.size());
    ++octants[(point.x > 0) + 2 * (point.y > 0) + 4 * (point.z > 0)];
  }
  CHECK(glm::length(mean) < 0.03);
  for (const std::size_t octant : octants) CHECK(std::abs(double(octant) - 500) < 50);

  const double cell = 2.0 / 40;  // no more points than cells inside
  CHECK(double(grid.insidePoints(1000000).size()) * cell * cell * cell ==
        doctest::Approx(grid.volume()).epsilon(0.002));
  CHECK(SolidGrid(groundGrid(1, 4), 16).insidePoints(100).empty());
}

TEST_CASE("a grid does not depend on the number of threads") {
  const TriangleMesh knot = torusKnot();
  setThreadCount(1);
  const auto one = SolidGrid(knot, 50).insidePoints(100000);
  setThreadCount(3);
  CHECK(SolidGrid(knot, 50).insidePoints(100000) == one);
  setThreadCount(0);
  CHECK(one.size() > 1000);
}
