#include "mesh/solid_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/error.h"
#include "mesh/mesh_measures.h"
#include "mesh/topology.h"
#include "solids/solid.h"

using namespace haarlight;

namespace {

constexpr double pi = std::numbers::pi;

struct KnownShape {
  Shape shape;
  double volume, size;  ///< the largest measure
};

const std::vector<KnownShape> knownShapes{
    {SphereShape{0.5}, 4 * pi / 3 * 0.125, 0.5},
    {EllipsoidShape{{1, 2, 0.25}}, 4 * pi / 3 * 0.5, 2},
    {BoxShape{{1, 2, 3}}, 48, 3},
    {CylinderShape{0.5, 3}, pi * 0.25 * 3, 3},
    {ConeShape{1, 2, 0}, pi * 2 / 3, 2},
    {ConeShape{1, 2, 0.5}, pi * 2 / 3 * (1 + 0.5 + 0.25), 2},
    {ConeShape{0.5, 2, 1}, pi * 2 / 3 * (1 + 0.5 + 0.25), 2},
    {TorusShape{2, 0.5}, 2 * pi* pi * 2 * 0.25, 2},
    {TorusShape{1, 1}, 2 * pi* pi, 1},
};

/// A point of the solid next to `position`, or one in the plane through it across its normal: of a
/// convex solid the furthest one that way; of a torus, on its tube.
glm::dvec3 poleFor(const Solid& solid, const glm::dvec3& position, const glm::dvec3& normal) {
  const auto* torus = std::get_if<TorusShape>(&solid.shape());
  if (!torus) return solid.support(normal);
  const glm::dvec3 flat(normal.x, 0, normal.z), level(position.x, 0, position.z);
  const bool inwards = glm::dot(flat, level) < 0;
  const double length = glm::length(flat);
  const glm::dvec3 outwards =
      length > 1e-6 ? (inwards ? -flat : flat) / length : glm::normalize(level);
  return torus->majorRadius * outwards + torus->minorRadius * glm::normalize(normal);
}

}  // namespace

TEST_CASE("a solid's polygons are closed and face outwards, whatever their number") {
  for (const KnownShape& known : knownShapes)
    for (const int segments : {3, 4, 5, 7, 12, 33, 64}) {
      const TriangleMesh mesh = solidMesh(known.shape, segments);
      const MeshTopology topology = measureTopology(mesh);
      CHECK(topology.closed);
      CHECK(topology.misorientedEdges == 0);
      CHECK(topology.nonManifoldEdges == 0);
      CHECK(topology.duplicateTriangles == 0);
      CHECK(topology.components == 1);
      CHECK(signedVolume(mesh) > 0);
      REQUIRE(mesh.normals.size() == mesh.positions.size());
      for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const glm::dvec3 facing = glm::cross(b - a, c - a);
        for (int corner = 0; corner < 3; ++corner)
          if (segments >= 12) CHECK(glm::dot(facing, glm::dvec3(mesh.normals[t[corner]])) > 0);
      }
    }
}

TEST_CASE("the volume of a solid's polygons tends to its closed form, four times as near as fine") {
  for (const KnownShape& known : knownShapes) {
    const auto error = [&](int segments) {
      return 1 - double(signedVolume(solidMesh(known.shape, segments))) / known.volume;
    };
    if (std::holds_alternative<BoxShape>(known.shape)) {
      CHECK(std::abs(error(3)) < 1e-6);
      continue;
    }
    const double coarse = error(32), fine = error(64);
    CHECK(coarse > 0);
    CHECK(coarse < 0.04);
    CHECK(coarse / fine == doctest::Approx(4).epsilon(0.03));
    CHECK(std::abs(error(512)) < 2e-4);
  }
}

TEST_CASE("all vertices of a solid's polygons lie on it, with its normals") {
  for (const KnownShape& known : knownShapes) {
    const Solid solid(known.shape);
    const TriangleMesh mesh = solidMesh(known.shape, 16);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const glm::dvec3 position(mesh.positions[i]), normal(mesh.normals[i]);
      if (!solid.isConvex() && position == glm::dvec3(0)) continue;  // no hole, and no normal there
      CHECK(glm::length(normal) == doctest::Approx(1).epsilon(1e-6));
      const glm::dvec3 pole = poleFor(solid, position, normal);
      CHECK(std::abs(glm::dot(pole - position, normal)) < 3e-7 * known.size);
      CHECK_FALSE(solid.contains(position + 1e-6 * known.size * normal));
      CHECK(solid.contains(pole));
    }
  }
}

TEST_CASE("rims have a normal for each side, smooth surfaces one for all") {
  const TriangleMesh cylinder = solidMesh(CylinderShape{1, 2}, 8);
  int up = 0, outwards = 0;
  for (std::size_t i = 0; i < cylinder.positions.size(); ++i) {
    if (cylinder.positions[i] != glm::vec3(1, 1, 0)) continue;
    up += cylinder.normals[i] == glm::vec3(0, 1, 0);
    outwards += cylinder.normals[i] == glm::vec3(1, 0, 0);
  }
  CHECK(up == 1);
  CHECK(outwards == 1);
  const TriangleMesh ball = solidMesh(SphereShape{2}, 24);
  for (std::size_t i = 0; i < ball.positions.size(); ++i)
    CHECK(glm::distance(ball.positions[i], 2.0f * ball.normals[i]) < 1e-6f);
}

TEST_CASE("needles and plates keep all of their polygons") {
  for (const Shape& shape : {Shape(CylinderShape{1e-6, 1e6}), Shape(ConeShape{1e6, 1e-6, 0}),
                             Shape(EllipsoidShape{{1e-6, 1e6, 1}}), Shape(TorusShape{1e6, 1})}) {
    const MeshTopology topology = measureTopology(solidMesh(shape, 24));
    CHECK(topology.closed);
    CHECK(topology.misorientedEdges == 0);
  }
}

TEST_CASE("what is no solid has no polygons") {
  CHECK_THROWS_AS(solidMesh(TorusShape{1, 2}, 8), InputError);
  CHECK_THROWS_AS(solidMesh(SphereShape{}, 2), std::invalid_argument);
}
