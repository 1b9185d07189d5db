#include "mesh/builtin_meshes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "mesh/mesh_measures.h"
#include "mesh/mesh_transform.h"
#include "mesh/topology.h"

using namespace haarlight;

namespace {

/// V - E + F.
long eulerCharacteristic(const TriangleMesh& mesh) {
  const MeshTopology topology = measureTopology(mesh);
  return long(topology.vertices) - long(topology.edges) + long(mesh.triangles.size());
}

/// Length of the torus knot's curve before scaling, by the trapezoidal rule, which is exact to
/// rounding for periodic functions.
double knotLength(const TorusKnot& shape) {
  constexpr int steps = 4000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double tube = shape.q * 2 * std::numbers::pi * i / steps;
    sum += std::hypot(shape.p * (2 + std::cos(tube)), shape.q);
  }
  return sum * 2 * std::numbers::pi / steps;
}

/// The factor by which torusKnot scales the tube to the unit ball, from the radius it has left.
double tubeRadiusOf(const TriangleMesh& mesh, const TorusKnot& shape) {
  return glm::distance(glm::dvec3(mesh.positions[0]),
                       glm::dvec3(mesh.positions[std::size_t(shape.tubeSegments) / 2])) /
         2;
}

double smallestNormalAgreement(const TriangleMesh& mesh) {
  double smallest = 1;
  for (const auto& t : mesh.triangles) {
    const auto& p = mesh.positions;
    const glm::vec3 flat = glm::normalize(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
    for (const auto vertex : {t.x, t.y, t.z})
      smallest = std::min(smallest, double(glm::dot(mesh.normals[vertex], flat)));
  }
  return smallest;
}

}  // namespace

TEST_CASE("the torus knot is a closed tube of genus one in the unit ball") {
  const TriangleMesh knot = torusKnot();
  const MeshTopology topology = measureTopology(knot);
  CHECK(topology.closed);
  CHECK(topology.misorientedEdges == 0);
  CHECK(topology.duplicateTriangles == 0);
  CHECK(topology.components == 1);
  CHECK(eulerCharacteristic(knot) == 0);
  CHECK(knot.triangles.size() == 12288);
  float largest = 0;
  for (const auto& position : knot.positions) largest = std::max(largest, glm::length(position));
  CHECK(largest == doctest::Approx(1).epsilon(1e-6));
  for (const auto& normal : knot.normals) CHECK(std::abs(glm::length(normal) - 1) < 1e-6f);
  // Within a triangle normals turn by at most a step round the tube, 15 degrees, and a step along
  // it: its length, 0.165 before scaling, over the least radius of curvature, 1.43: 7 degrees.
  CHECK(smallestNormalAgreement(knot) > std::cos(22 * std::numbers::pi / 180));
}

TEST_CASE("the torus knot has the volume of its tube") {
  // Pappus: the volume of a tube is the area of its section, here a regular polygon, times the
  // length of the curve. Between two sections that are turned by t against each other straight
  // edges shrink the section by t² / 6 on average; sections turn round the curve by up to 2π q / n
  // and with it by up to length / n over the least radius of curvature, 1.43.
  double lastError = 0;
  for (const int segments : {128, 256, 512}) {
    const TorusKnot shape{.lengthSegments = segments};
    const TriangleMesh knot = torusKnot(shape);
    const double radius = tubeRadiusOf(knot, shape), scale = radius / shape.tubeRadius;
    const double n = shape.tubeSegments;
    const double section = n / 2 * radius * radius * std::sin(2 * std::numbers::pi / n);
    const double expected = section * knotLength(shape) * scale;
    const double error = std::abs(signedVolume(knot) / expected - 1);
    CHECK(signedVolume(knot) > 0);
    const double twist = 2 * std::numbers::pi * shape.q / segments;
    const double bend = knotLength(shape) / 1.43 / segments;
    CHECK(error < (twist * twist + bend * bend) / 6);
    if (lastError > 0) CHECK(lastError / error == doctest::Approx(4).epsilon(0.1));
    lastError = error;
  }
}

TEST_CASE("the icosphere approaches the unit sphere") {
  for (const int level : {0, 1, 2, 3}) {
    const TriangleMesh sphere = icosphere(level);
    CHECK(sphere.triangles.size() == 20u << (2 * level));
    CHECK(eulerCharacteristic(sphere) == 2);
    CHECK(measureTopology(sphere).closed);
    CHECK(measureTopology(sphere).misorientedEdges == 0);
    for (const auto& p : sphere.positions) CHECK(std::abs(glm::length(p) - 1) < 1e-6f);
  }
  // The icosahedron in the unit sphere: edge 1 / sin(2π/5), volume 5 (3 + √5) / 12 · edge³.
  const double edge = 1 / std::sin(2 * std::numbers::pi / 5);
  CHECK(signedVolume(icosphere(0)) ==
        doctest::Approx(5 * (3 + std::sqrt(5.0)) / 12 * edge * edge * edge).epsilon(1e-6));
  CHECK(signedVolume(icosphere(5)) == doctest::Approx(4.0 / 3 * std::numbers::pi).epsilon(2e-3));
}

TEST_CASE("the ground grid is flat, faces up and has its area") {
  const TriangleMesh grid = groundGrid(2, 5);
  CHECK(grid.triangles.size() == 50);
  CHECK(surfaceArea(grid) == doctest::Approx(16).epsilon(1e-6));
  CHECK(smallestNormalAgreement(grid) == doctest::Approx(1));
  CHECK(measureTopology(grid).boundaryEdges == 20);
}

TEST_CASE("moved meshes keep normals and winding in agreement") {
  const TriangleMesh sphere = icosphere(3);
  const glm::mat4 mirror = glm::scale(glm::mat4(1), glm::vec3(-2, 1, 0.5f));
  const TriangleMesh mirrored = transformed(sphere, mirror);
  CHECK(signedVolume(mirrored) == doctest::Approx(signedVolume(sphere)).epsilon(1e-6));
  // The ellipsoid (x/a)² + (y/b)² + (z/c)² = 1 has the normal (x/a², y/b², z/c²).
  for (std::size_t i = 0; i < mirrored.positions.size(); ++i) {
    const glm::vec3 expected = glm::normalize(mirrored.positions[i] / glm::vec3(4, 1, 0.25f));
    CHECK(glm::distance(mirrored.normals[i], expected) < 1e-5f);
  }
  const glm::mat4 moved = glm::rotate(glm::translate(glm::mat4(1), glm::vec3(1, 2, 3)), 0.7f,
                                      glm::normalize(glm::vec3(1, 2, -1)));
  const TriangleMesh rigid = transformed(sphere, moved);
  CHECK(signedVolume(rigid) == doctest::Approx(signedVolume(sphere)).epsilon(1e-5));
  CHECK(smallestNormalAgreement(rigid) > 0.98);
}
