#include "motion/moving_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <stdexcept>

#include "mesh/builtin_meshes.h"
#include "mesh/vertex_normals.h"
#include "motion/deformers.h"
#include "motion/point_cache.h"
#include "motion/point_cache_bytes.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

MeshDeformation twistBy(AngleOverTime degrees) {
  MeshDeformation deformation;
  deformation.twist = TwistOverTime{Axis::y, std::move(degrees)};
  return deformation;
}

AngleOverTime constant(double degrees) {
  return [degrees](double) { return degrees; };
}

/// A cube of three vertices at each corner, whose normals are those of its sides.
TriangleMesh hardCube() {
  TriangleMesh cube;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      const auto first = std::uint32_t(cube.positions.size());
      glm::vec3 normal(0), u(0), v(0);
      normal[axis] = float(side);
      u[(axis + 1) % 3] = float(side);
      v[(axis + 2) % 3] = 1;
      for (const glm::vec3& p : {-u - v, u - v, u + v, v - u}) {
        cube.positions.push_back(normal + p);
        cube.normals.push_back(normal);
      }
      cube.triangles.emplace_back(first, first + 1, first + 2);
      cube.triangles.emplace_back(first, first + 2, first + 3);
    }
  return cube;
}

/// Gives the vertices it was made with, moved along x by the seconds, for two seconds.
class Slide final : public VertexMotion {
 public:
  explicit Slide(std::vector<glm::vec3> positions) : positions_(std::move(positions)) {}
  std::size_t vertexCount() const override { return positions_.size(); }
  double duration() const override { return 2; }
  std::vector<glm::vec3> positions(double seconds) override {
    std::vector<glm::vec3> moved = positions_;
    for (glm::vec3& p : moved) p.x += float(seconds);
    return moved;
  }

 private:
  std::vector<glm::vec3> positions_;
};

}  // namespace

TEST_CASE("a mesh that nothing deforms stays as it was loaded") {
  TriangleMesh sphere = icosphere(1);
  for (glm::vec3& normal : sphere.normals) normal = {0, 0, 1};
  DeformingMesh mesh(sphere);
  CHECK_FALSE(mesh.deforms());
  CHECK_FALSE(mesh.moves());
  const TriangleMesh later = mesh.meshAt(3);
  CHECK(sameBits(later.positions, sphere.positions));
  CHECK(sameBits(later.normals, sphere.normals));
  CHECK(later.triangles == sphere.triangles);
}

TEST_CASE("twist and bend go by the box of the mesh at rest, twist first") {
  const TriangleMesh knot = torusKnot({.lengthSegments = 32, .tubeSegments = 6});
  const BoundingBox box = boundingBox(knot);
  MeshDeformation deformation = twistBy([](double seconds) { return 40 * seconds; });
  deformation.bend = BendOverTime{Axis::x, Axis::y, [](double seconds) { return 10 + seconds; }};
  DeformingMesh mesh(knot, std::move(deformation));
  CHECK(mesh.moves());
  const auto expected = bent(twisted(knot.positions, box, Axis::y, 120), box, Axis::x, Axis::y, 13);
  CHECK(sameBits(mesh.positions(3), expected));
  mesh.positions(50);
  CHECK(sameBits(mesh.positions(3), expected));
  const TriangleMesh at = mesh.meshAt(3);
  CHECK(sameBits(at.positions, expected));
  CHECK(sameBits(at.normals, computeVertexNormals(expected, knot.triangles)));
  CHECK(at.triangles == knot.triangles);
}

TEST_CASE("normals are those of the deformed surface") {
  // A twist turns each level of a sphere in itself: all points move, and the sphere stays one.
  const TriangleMesh sphere = icosphere(4);
  const TriangleMesh twist = DeformingMesh(sphere, twistBy(constant(180))).meshAt(0);
  double farthest = 0;
  for (std::size_t i = 0; i < twist.positions.size(); ++i) {
    CHECK(glm::distance(twist.normals[i], glm::normalize(twist.positions[i])) < 0.05f);
    farthest = std::max(farthest, double(glm::distance(twist.normals[i], sphere.normals[i])));
  }
  CHECK(farthest > 0.5);
}

TEST_CASE("hard edges stay hard when a mesh deforms, and normals do not jump on the way") {
  const TriangleMesh cube = hardCube();
  DeformingMesh mesh(cube, twistBy([](double seconds) { return seconds; }));
  for (const double degrees : {0.0, 0.01, 30.0}) {
    const TriangleMesh twist = mesh.meshAt(degrees);
    for (std::size_t i = 0; i < cube.positions.size(); ++i) {
      CAPTURE(degrees);
      // Sides turn by up to 15 degrees and lean; those of 90 degrees stay far apart.
      CHECK(glm::distance(twist.normals[i], cube.normals[i]) < 1e-6 + 0.0175 * degrees);
    }
  }
}

TEST_CASE("a motion of vertices hangs on the scene's clock") {
  const TriangleMesh sphere = icosphere(1);
  const auto slid = [&](float x) {
    std::vector<glm::vec3> positions = sphere.positions;
    for (glm::vec3& p : positions) p.x += x;
    return positions;
  };
  DeformingMesh mesh(
      sphere, {std::make_unique<Slide>(sphere.positions), {10, 0.5, Repeat::pingpong}, {}, {}});
  CHECK(mesh.moves());
  CHECK(sameBits(mesh.positions(3), slid(0)));
  CHECK(sameBits(mesh.positions(12), slid(1)));
  CHECK(sameBits(mesh.positions(14), slid(2)));
  CHECK(sameBits(mesh.positions(15), slid(1.5f)));
  CHECK(sameBits(mesh.positions(18), slid(0)));
  CHECK_THROWS_AS(
      DeformingMesh(icosphere(0), {std::make_unique<Slide>(sphere.positions), {}, {}, {}}),
      std::invalid_argument);
}

TEST_CASE("a cache of one frame deforms a mesh without moving it") {
  const TemporaryFolder folder;
  const TriangleMesh sphere = icosphere(0);
  const Frames frames = randomFrames(1, sphere.positions.size(), 1);
  writeFile(folder / "a.pc2", pc2Bytes(frames));
  LoadedMesh loaded = meshWithVertices(sphere.positions.size());
  DeformingMesh mesh(sphere, {openPointCache(folder / "a.pc2", loaded, 24), {}, {}, {}});
  CHECK(mesh.deforms());
  CHECK_FALSE(mesh.moves());
  CHECK(sameBits(mesh.meshAt(5).positions, frames[0]));
  CHECK(sameBits(mesh.meshAt(5).normals, computeVertexNormals(frames[0], sphere.triangles)));
}
