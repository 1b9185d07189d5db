#include "mesh_shadow/classic_volume.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/builtin_meshes.h"
#include "mesh_shadow/mesh_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A view of the origin from a place, 60° wide.
PixelView viewFrom(const glm::dvec3& eye, int size) {
  const glm::dvec3 forward = glm::normalize(-eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.1, 1, 0.2)));
  const glm::dvec3 down = glm::cross(forward, right);
  const double step = 2 * std::tan(std::acos(-1.0) / 6) / size;
  const glm::dvec3 corner = forward - (0.5 * size - 0.5) * step * (right + down);
  return {eye, corner, step * right, step * down, size, size};
}

glm::dvec3 direction(const PixelView& view, int x, int y) {
  return view.corner + double(x) * view.column + double(y) * view.row;
}

/// Triangles between a point and the light, one by one.
int trianglesBetween(const TriangleMesh& mesh, const glm::dvec3& point, const ShadowLight& light) {
  const Ray ray = segmentToLight(point, light);
  const glm::dvec3 way = (std::isfinite(ray.far) ? 1.0 : 1e3) * ray.direction;
  int count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    count += meets(point, way, mesh, t).has_value();
  return count;
}

}  // namespace

TEST_CASE(
    "counting in and out of shadow volumes gives the triangles between a point and the light") {
  RandomNumbers random(1);
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh mesh = randomMesh(i % meshKinds, 0.5, random);
    ShadowLight light = PointLight{randomPoint(random, 3)};
    if (i % 3 == 0) light = DirectionalLight{randomDirection(random)};
    // From outside and, with luck, from within shadows and meshes.
    const PixelView view = viewFrom(uniform(random, 0.3, 3) * randomDirection(random), 24);
    std::vector<double> depths(24 * 24);
    for (double& depth : depths) depth = std::pow(10, uniform(random, -1, 1));
    std::vector<std::int32_t> counts(depths.size());
    const LitMesh lit(mesh, light);
    ClassicVolume(lit).addCounts(view, depths, counts, 0);
    std::vector<std::int32_t> ofEachTriangle(depths.size());
    const ClassicVolume all(lit, ClassicVolume::Sides::ofEachTriangle);
    all.addCounts(view, depths, ofEachTriangle, 0);
    CHECK(ofEachTriangle == counts);
    CHECK(all.faceCount() >= ClassicVolume(lit).faceCount());
    CAPTURE(i);
    int shadowed = 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const auto pixel = std::size_t(24 * y + x);
        const glm::dvec3 point = view.eye + depths[pixel] * direction(view, x, y);
        REQUIRE(counts[pixel] == trianglesBetween(mesh, point, light));
        shadowed += counts[pixel] > 0;
      }
    if (i % meshKinds < 2) CHECK(shadowed > 0);
  }
}

TEST_CASE("the sides of a closed mesh are those of its silhouette; no point of it hides itself") {
  const TriangleMesh ball = icosphere(2);
  const DirectionalLight sun{{0.3, 1, 0.2}};
  const LitMesh lit(ball, sun);
  const ClassicVolume volume(lit);
  CHECK(volume.faceCount() == lit.triangleCount() + lit.silhouette().size());
  const LitMesh byLamp(ball, PointLight{{0.3, 5, 1.1}});
  CHECK(ClassicVolume(byLamp).faceCount() ==
        byLamp.triangleCount() + 2 * byLamp.silhouette().size());

  const PixelView view = viewFrom({1, 2.5, 2}, 64);
  std::vector<double> depths(64 * 64, std::numeric_limits<double>::infinity());
  std::vector<std::int32_t> counts(depths.size()), triangles(depths.size(), -1);
  for (int pixel = 0; pixel < 64 * 64; ++pixel)
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
      const glm::dvec3 way = 10.0 * direction(view, pixel % 64, pixel / 64);
      const auto at = meets(view.eye, way, ball, t);
      if (at && 10 * *at < depths[std::size_t(pixel)])
        depths[std::size_t(pixel)] = 10 * *at, triangles[std::size_t(pixel)] = int(t);
    }
  volume.addCounts(view, depths, counts);
  int seen = 0;
  for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
    if (triangles[pixel] < 0) continue;
    ++seen;
    const glm::uvec3 t = ball.triangles[std::size_t(triangles[pixel])];
    const glm::dvec3 a = ball.positions[t.x], b = ball.positions[t.y], c = ball.positions[t.z];
    const bool facesLight = glm::dot(glm::cross(b - a, c - a), sun.towards) > 0;
    CHECK((counts[pixel] > 0) == !facesLight);
  }
  CHECK(seen > 800);
}
