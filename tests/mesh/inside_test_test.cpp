#include "mesh/inside_test.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/parallel.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/solid_repair.h"
#include "mesh/test_meshes.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Sum of the triangles' solid angles (van Oosterom and Strackee 1983) over 4π.
double exactWindingNumber(const TriangleMesh& mesh, const glm::vec3& point) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = glm::dvec3(mesh.positions[t.x]) - glm::dvec3(point),
                     b = glm::dvec3(mesh.positions[t.y]) - glm::dvec3(point),
                     c = glm::dvec3(mesh.positions[t.z]) - glm::dvec3(point);
    const double lengthA = glm::length(a), lengthB = glm::length(b), lengthC = glm::length(c);
    sum += 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                          lengthA * lengthB * lengthC + glm::dot(a, b) * lengthC +
                              glm::dot(b, c) * lengthA + glm::dot(c, a) * lengthB);
  }
  return sum / (4 * std::numbers::pi);
}

/// In the bounding box made larger by a tenth; the same for the same number.
glm::vec3 pointAround(const BoundingBox& bounds, std::size_t number) {
  Random random(number);
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  const glm::dvec3 lower = bounds.lower, upper = bounds.upper;
  return glm::vec3(lower + (upper - lower) * (1.1 * glm::dvec3(x, y, z) - 0.05));
}

/// Share of `count` points for which `inside` and expected(point) differ.
template <typename Expected>
double differing(const TriangleMesh& mesh, std::size_t count, const Expected& expected) {
  const InsideTest inside(mesh);
  const BoundingBox bounds = boundingBox(mesh);
  std::atomic<std::size_t> different = 0;
  parallelFor(count, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const glm::vec3 point = pointAround(bounds, i);
      different += inside.contains(point) != expected(point);
    }
  });
  return double(different) / double(count);
}

double differingFromExact(const TriangleMesh& mesh, std::size_t count) {
  return differing(mesh, count, [&](const glm::vec3& point) {
    return std::abs(exactWindingNumber(mesh, point)) > 0.5;
  });
}

/// The largest error at `count` points.
double largestError(const TriangleMesh& mesh, std::size_t count) {
  const WindingNumber windingNumber(mesh);
  const BoundingBox bounds = boundingBox(mesh);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 point = pointAround(bounds, i);
    largest = std::max(largest, std::abs(windingNumber(point) - exactWindingNumber(mesh, point)));
  }
  return largest;
}

}  // namespace

TEST_CASE("the winding number of a bowl is that of a hemisphere") {
  // Bowl and disc together have 1 inside, and a disc of radius 1 takes 2π (1 - d / √(d² + 1)) of
  // the directions at distance d from its centre; the same holds above it with d < 0.
  const WindingNumber windingNumber(bowl(256));
  for (const double d : {0.9, 0.5, 0.1, 0.01, 0.0, -0.1, -1.0, -5.0}) {
    const double expected = 0.5 + d / (2 * std::sqrt(d * d + 1));
    CHECK(windingNumber(glm::vec3(0, -d, 0)) == doctest::Approx(expected).epsilon(0.01));
  }
  CHECK(std::abs(windingNumber({0, -1.5f, 0})) < 0.3f);
  CHECK(windingNumber({0, -1.5f, 0}) ==
        doctest::Approx(exactWindingNumber(bowl(256), {0, -1.5f, 0})).epsilon(0.01));
}

TEST_CASE("the winding number stays near the sum of solid angles") {
  for (const TriangleMesh& mesh : {torusKnot(), bowl(64), sphereAt({0, 0, 0}, 1), cubeStack(2)}) {
    CHECK(largestError(mesh, 1000) < 0.01);
  }
}

TEST_CASE("unions, cavities and touching parts have the inside that they should") {
  const glm::vec3 left(-0.4f, 0, 0), right(0.4f, 0, 0), center(0);
  // An inscribed sphere of this many triangles lies within 1e-3 of the true one.
  const auto inBall = [](const glm::vec3& p, const glm::vec3& middle, float radius) {
    return glm::distance(p, middle) < radius;
  };
  CHECK(differing(combined(sphereAt(left, 1, 5), sphereAt(right, 1, 5)), 20000,
                  [&](const glm::vec3& p) { return inBall(p, left, 1) || inBall(p, right, 1); }) <
        1e-3);
  const auto shell = combined(sphereAt(center, 1, 5), turnedOver(sphereAt(center, 0.6f, 5)));
  CHECK(differing(shell, 20000, [&](const glm::vec3& p) {
          return inBall(p, center, 1) && !inBall(p, center, 0.6f);
        }) < 1e-3);
  const auto inUnitBox = [](const glm::vec3& p, float size) {
    return p.x > 0 && p.y > 0 && p.z > 0 && p.x < size && p.y < size && p.z < size;
  };
  for (const bool mixedDiagonals : {false, true})
    CHECK(differing(cubeStack(3, mixedDiagonals), 20000,
                    [&](const glm::vec3& p) { return inUnitBox(p, 3); }) == 0);
  CHECK(differing(box({0, 0, 0}, {1, 1, 1e-3f}), 20000, [](const glm::vec3& p) {
          return p.x > 0 && p.y > 0 && p.z > 0 && p.x < 1 && p.y < 1 && p.z < 1e-3f;
        }) == 0);
}

TEST_CASE("the inside does not depend on the size and place of a mesh") {
  const TriangleMesh knot = torusKnot();
  for (const float scale : {1e-6f, 1.0f, 1e6f})
    for (const float offset : {0.0f, 1e3f}) {
      const glm::vec3 by = scale * offset * glm::vec3(1, -2, 3);
      const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1), by), glm::vec3(scale));
      CHECK(differingFromExact(transformed(knot, place), 1000) == 0);
    }
}

TEST_CASE("neighbours that disagree spoil the inside, and the repair restores it") {
  const TriangleMesh knot = torusKnot(), mixed = turnedOver(knot, 3);
  const auto exact = [&](const glm::vec3& p) {
    return std::abs(exactWindingNumber(knot, p)) > 0.5;
  };
  CHECK(differing(mixed, 1000, exact) > 0.05);
  CHECK(differing(prepareSolid(mixed).mesh, 1000, exact) == 0);
}

TEST_CASE("an open bowl is inside where more than half of the directions meet it") {
  CHECK(differingFromExact(bowl(64), 20000) < 2e-3);
}

TEST_CASE("bunny with its holes, and armadillo, have the inside of the exact winding number") {
  for (const char* name : {"meshes/bunny.obj", "meshes/armadillo.obj"}) {
    const auto path = testData(name);
    if (!path) return;
    const TriangleMesh mesh = prepareSolid(loadMesh(*path).mesh).mesh;
    CHECK(differingFromExact(mesh, 2000) < 1e-3);
  }
}
