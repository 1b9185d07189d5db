#include "mesh_shadow/crossed_triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/builtin_meshes.h"
#include "mesh_shadow/mesh_scenes.h"
#include "mesh_shadow/plain_triangles.h"
#include "mesh_shadow/triangle_contact.h"
#include "shadow/convex_gap.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

struct Triangles {
  std::vector<BoxedTriangle> boxed;
  std::vector<VertexTriple> corners;

  explicit Triangles(const LitMesh& mesh) : corners(mesh.triangles()) {
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) boxed.emplace_back(mesh.corners(t));
  }
};

LitMesh underSun(const TriangleMesh& mesh) {
  return LitMesh(mesh, DirectionalLight{{0.3, 1, 0.2}});
}

std::vector<std::uint8_t> crossedIn(const TriangleMesh& mesh) {
  const Triangles triangles(underSun(mesh));
  return findCrossedTriangles(triangles.boxed, triangles.corners);
}

std::vector<std::uint8_t> plainIn(const TriangleMesh& mesh) {
  return findPlainTriangles(underSun(mesh), crossedIn(mesh));
}

/// Where a segment meets a triangle that has no corner in common with it.
bool segmentMeets(const glm::dvec3& a, const glm::dvec3& b, const TriangleCorners& t) {
  const auto volume = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    return glm::dot(glm::cross(q - p, r - p), b - a);
  };
  const double u = volume(a, t[0], t[1]), v = volume(a, t[1], t[2]), w = volume(a, t[2], t[0]);
  if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return false;
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  return glm::dot(normal, a - t[0]) * glm::dot(normal, b - t[0]) <= 0;
}

/// Whether an edge of one triangle, without the corners that both have, meets the other.
bool edgesCross(const NumberedTriangle& one, const NumberedTriangle& other) {
  const auto isShared = [&](int i) {
    return std::ranges::count(other.numbers, one.numbers[i]) > 0;
  };
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    if (isShared(i) && isShared(k)) continue;
    glm::dvec3 a = one.corners[i], b = one.corners[k];
    const glm::dvec3 step = 1e-6 * (b - a);
    if (isShared(i)) a += step;
    if (isShared(k)) b -= step;
    if (segmentMeets(a, b, other.corners)) return true;
  }
  return false;
}

/// Whether triangles in the plane y = 0 overlap, as one of many points of the one shows.
bool overlapInPlane(const TriangleCorners& a, const TriangleCorners& b, RandomNumbers& random) {
  const auto side = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    return glm::cross(q - p, r - p).y;
  };
  for (int i = 0; i < 50; ++i) {
    double v = uniform(random, 0, 1), w = uniform(random, 0, 1);
    if (v + w > 1) v = 1 - v, w = 1 - w;
    const glm::dvec3 point = a[0] + v * (a[1] - a[0]) + w * (a[2] - a[0]);
    const double x = side(b[0], b[1], point), y = side(b[1], b[2], point),
                 z = side(b[2], b[0], point);
    if ((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0)) return true;
  }
  return false;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh result = a;
  const auto offset = std::uint32_t(a.positions.size());
  result.positions.insert(result.positions.end(), b.positions.begin(), b.positions.end());
  for (const glm::uvec3& t : b.triangles) result.triangles.push_back(t + offset);
  return result;
}

TriangleMesh moved(TriangleMesh mesh, const glm::vec3& by) {
  for (glm::vec3& p : mesh.positions) p += by;
  return mesh;
}

bool isNone(const std::vector<std::uint8_t>& flags) {
  return std::ranges::count(flags, 0) == std::ptrdiff_t(flags.size());
}
bool isAll(const std::vector<std::uint8_t>& flags) {
  return std::ranges::count(flags, 1) == std::ptrdiff_t(flags.size());
}

}  // namespace

TEST_CASE("two triangles that are said to be apart have no more in common than their corners") {
  RandomNumbers random(1);
  int crossing = 0, apart = 0, inDoubt = 0;
  for (int i = 0; i < 60000; ++i) {
    const int shared = i % 3;
    TriangleCorners a, b;
    VertexTriple numbersA{0, 1, 2}, numbersB{3, 4, 5};
    const glm::dvec3 between = randomPoint(random, 1 - 0.5 * shared);
    const double flatness = i % 5 ? 1 : 0;  // some in one plane
    for (int k = 0; k < 3; ++k) {
      a[k] = randomPoint(random, 1), b[k] = between + randomPoint(random, 1);
      a[k].y *= flatness, b[k].y *= flatness;
      if (k < shared) b[k] = a[k], numbersB[k] = numbersA[k];
    }
    const NumberedTriangle one{a, numbersA}, other{b, numbersB};
    const bool cross = flatness > 0 ? edgesCross(one, other) || edgesCross(other, one)
                                    : overlapInPlane(a, b, random) || overlapInPlane(b, a, random);
    const bool may = mayTouchElsewhere(one, other);
    CHECK(may == mayTouchElsewhere(other, one));
    if (cross) REQUIRE(may);
    crossing += cross, apart += !may, inDoubt += may && !cross;
  }
  MESSAGE(crossing << " cross, " << apart << " do not, " << inDoubt << " in doubt");
  CHECK(crossing > 5000);
  CHECK(apart > 20000);
  CHECK(inDoubt < 600);  // of those in one plane, points may miss what two have in common
}

TEST_CASE("the triangles that others cross are those that comparing all pairs finds") {
  RandomNumbers random(2);
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh mesh = joined(randomMesh(i % meshKinds, 0.2, random),
                                     randomMesh(int(random() % meshKinds), 0.2, random));
    const Triangles triangles(underSun(mesh));
    std::vector<std::uint8_t> expected(triangles.boxed.size());
    for (std::size_t a = 0; a < expected.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (mayTouchElsewhere({triangles.boxed[a].corners, triangles.corners[a]},
                              {triangles.boxed[b].corners, triangles.corners[b]}))
          expected[a] = expected[b] = 1;
    CHECK(findCrossedTriangles(triangles.boxed, triangles.corners) == expected);
  }
}

TEST_CASE("meshes that cross themselves, and meshes that do not") {
  const TriangleMesh ball = icosphere(3);
  for (const TriangleMesh& mesh : {ball, torusKnot(), groundGrid(1, 5), TriangleMesh{}}) {
    CHECK(isNone(crossedIn(mesh)));
    CHECK(isAll(plainIn(mesh)));
  }
  CHECK(isAll(crossedIn(joined(ball, ball))));
  const auto crossed = crossedIn(joined(ball, moved(ball, {1, 0.01f, 0.02f})));
  const auto count = std::ranges::count(crossed, 1);  // along one circle on each
  CHECK(count > 100);
  CHECK(count < 400);
  // Ten thousand triangles around one place are too many to compare.
  TriangleMesh bundle;
  for (std::uint32_t i = 0; i < 10000; ++i) {
    for (const glm::vec3& p :
         {glm::vec3(0, float(i), 0), glm::vec3(9e4f, float(i), 0), glm::vec3(9e4f, float(i), 9e4f)})
      bundle.positions.push_back(p);
    bundle.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  CHECK(isAll(crossedIn(bundle)));
}

TEST_CASE("a mesh is a surface where triangles follow each other once around their corners") {
  // Two tetrahedra that touch at a corner: each triangle at it belongs to no one surface there.
  const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {},
                                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  TriangleMesh opposite = tetrahedron;
  for (glm::vec3& p : opposite.positions) p = -p;
  CHECK(isAll(plainIn(tetrahedron)));
  const auto atCorner = plainIn(joined(tetrahedron, opposite));
  CHECK(std::ranges::count(atCorner, 1) == 2);  // those that do not have the corner
  // Three sheets at an edge.
  const TriangleMesh leaves{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, -1}},
                            {},
                            {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  CHECK(isNone(crossedIn(leaves)));
  CHECK(isNone(plainIn(leaves)));
  CHECK(isAll(plainIn(groundGrid(1, 1))));
}
