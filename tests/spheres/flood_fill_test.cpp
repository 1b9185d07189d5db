#include "spheres/flood_fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "mesh/mesh_measures.h"
#include "mesh/test_meshes.h"
#include "spheres/random_spheres.h"
#include "spheres/sphere_measures.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Two spheres with a gap of 0.05 between them, in a box of size 1: of radius 0.3 around
/// (-0.2, 0, 0) and of radius 0.1 around (0.25, 0, 0).
TriangleMesh largeAndSmall() {
  return combined(sphereAt({-0.2f, 0, 0}, 0.3f, 4), sphereAt({0.25f, 0, 0}, 0.1f, 4));
}

/// Of the points of a mesh, as fits use them.
std::vector<glm::vec3> pointsOf(const TriangleMesh& mesh, std::size_t count) {
  std::vector<glm::vec3> points = sampleSurface(mesh, count, 1);
  const std::vector<glm::vec3> interior = sampleInterior(mesh, count / 2, 2);
  points.insert(points.end(), interior.begin(), interior.end());
  return points;
}

std::vector<glm::dvec3> someOf(const std::vector<glm::vec3>& points, std::size_t count) {
  std::vector<glm::dvec3> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.emplace_back(points[i * points.size() / count]);
  return chosen;
}

/// The same clustering without tables or limits on what is near: outside volumes as the grid has
/// them at its finest.
std::vector<std::uint32_t> floodSlowly(const std::vector<glm::vec3>& points,
                                       const std::vector<glm::dvec3>& centers,
                                       const SolidGrid& solid) {
  const auto distance = [&](std::size_t point, std::size_t center) {
    return glm::distance(glm::dvec3(points[point]), centers[center]);
  };
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < centers.size(); ++c)
      nearest[i] = std::min(nearest[i], distance(i, c));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::sort(order, {}, [&](std::size_t i) { return nearest[i]; });
  std::vector<double> radii(centers.size());
  std::vector<std::uint32_t> joined(points.size());
  for (const std::size_t i : order) {
    double least = std::numeric_limits<double>::max(), depth = 0;
    for (std::size_t c = 0; c < centers.size(); ++c) {
      const double grown = std::max(radii[c], distance(i, c));
      const double rise = grown == radii[c] ? 0
                                            : solid.outsideVolume({centers[c], grown}) -
                                                  solid.outsideVolume({centers[c], radii[c]});
      if (rise > least || (rise == least && radii[c] - distance(i, c) <= depth)) continue;
      least = rise;
      depth = radii[c] - distance(i, c);
      joined[i] = static_cast<std::uint32_t>(c);
    }
    radii[joined[i]] = std::max(radii[joined[i]], distance(i, joined[i]));
  }
  return joined;
}

}  // namespace

TEST_CASE("all points join the only centre, and no points join none") {
  const SolidGrid solid(largeAndSmall(), 32);
  const std::vector<glm::vec3> points = pointsOf(largeAndSmall(), 300);
  const std::vector<glm::dvec3> center = {{0.4, 0.1, -0.3}};
  const auto joined = floodFill(points, center, solid);
  CHECK(joined == std::vector<std::uint32_t>(points.size(), 0));
  CHECK(floodFill({}, center, solid).empty());
}

TEST_CASE("points join the ball that grows within the solid, also where another is nearer") {
  const TriangleMesh large = sphereAt({-0.2f, 0, 0}, 0.3f, 4);
  const TriangleMesh small = sphereAt({0.25f, 0, 0}, 0.1f, 4);
  std::vector<glm::vec3> points = sampleSurface(large, 2000, 1);
  const std::size_t ofLarge = points.size();
  const auto more = sampleSurface(small, 500, 2);
  points.insert(points.end(), more.begin(), more.end());
  const std::vector<glm::dvec3> centers = {{-0.2, 0, 0}, {0.25, 0, 0}};
  const auto joined = floodFill(points, centers, SolidGrid(combined(large, small), 128));
  int nearerToOther = 0, misled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t own = i < ofLarge ? 0 : 1;
    const glm::dvec3 point = points[i];
    nearerToOther += glm::distance(point, centers[own]) > glm::distance(point, centers[1 - own]);
    misled += joined[i] != own;
  }
  CHECK(nearerToOther > 50);
  CHECK(misled == 0);
}

TEST_CASE("flood fill is what its definition says, but for tabulated volumes") {
  for (const TriangleMesh& mesh : {largeAndSmall(), torusKnot()}) {
    const SolidGrid solid(mesh, 64);
    const std::vector<glm::vec3> points = pointsOf(mesh, 800);
    const std::vector<glm::dvec3> centers = someOf(points, 10);
    const auto joined = floodFill(points, centers, solid);
    const auto expected = floodSlowly(points, centers, solid);
    int different = 0;
    for (std::size_t i = 0; i < points.size(); ++i) different += joined[i] != expected[i];
    CHECK(different < int(points.size()) / 20);
  }
}

TEST_CASE("flood fill depends neither on the order of points nor on the number of threads") {
  const TriangleMesh mesh = torusKnot();
  const SolidGrid solid(mesh, 64);
  std::vector<glm::vec3> points = pointsOf(mesh, 2000);
  const std::vector<glm::dvec3> centers = someOf(points, 40);
  const auto joined = floodFill(points, centers, solid);
  CHECK(*std::ranges::max_element(joined) < centers.size());
  for (const unsigned threads : {1, 3}) {
    setThreadCount(threads);
    CHECK(floodFill(points, centers, solid) == joined);
  }
  setThreadCount(0);
  std::ranges::reverse(points);
  auto reversed = floodFill(points, centers, solid);
  std::ranges::reverse(reversed);
  CHECK(reversed == joined);
}

TEST_CASE("a point that is a centre joins it") {
  const TriangleMesh mesh = torusKnot();
  const std::vector<glm::vec3> points = pointsOf(mesh, 1000);
  const std::vector<glm::dvec3> centers = someOf(points, 25);
  const auto joined = floodFill(points, centers, SolidGrid(mesh, 64));
  for (std::size_t c = 0; c < centers.size(); ++c)
    CHECK(joined[c * points.size() / centers.size()] == c);
}
