#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "mesh/builtin_meshes.h"
#include "mesh/mesh_transform.h"
#include "mesh/test_meshes.h"
#include "spheres/random_spheres.h"
#include "spheres/sphere_measures.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

bool contains(const Sphere& sphere, const glm::vec3& point) {
  return glm::distance(sphere.center, point) <= sphere.radius;
}

double distance(const Sphere& sphere, const glm::vec3& point) {
  return glm::distance(glm::dvec3(sphere.center), glm::dvec3(point));
}

/// Index of the sphere whose volume has to grow least to hold the point.
std::size_t cheapest(const std::vector<Sphere>& spheres, const glm::vec3& point) {
  const auto growth = [&](const Sphere& sphere) {
    return std::pow(distance(sphere, point), 3) - std::pow(double(sphere.radius), 3);
  };
  return std::size_t(std::ranges::min_element(spheres, {}, growth) - spheres.begin());
}

}  // namespace

TEST_CASE("a point goes to the sphere whose volume grows least") {
  // Nearer to the surface of the second, by 0.5 against 2, but 4.5³ - 4³ > 3³ - 1³.
  const std::vector<Sphere> spheres = {{{0, 0, 0}, 1}, {{7.5f, 0, 0}, 4}};
  const auto grown = grownToCover(spheres, std::vector<glm::vec3>{{3, 0, 0}});
  CHECK(grown[0].radius == doctest::Approx(3).epsilon(2e-6));
  CHECK(grown[0].radius >= 3);
  CHECK(grown[1].radius == 4);
  const auto other = grownToCover(spheres, std::vector<glm::vec3>{{3.1f, 0, 0}});
  CHECK(other[0].radius == 1);
  CHECK(other[1].radius == doctest::Approx(4.4).epsilon(2e-6));
}

TEST_CASE("spheres grow just enough to cover all points") {
  for (const double extent : {1e-3, 1.0, 1e4}) {
    const glm::dvec3 middle = extent * glm::dvec3(3, -2, 5);
    const std::vector<Sphere> spheres = randomSpheres(30, 1, extent, middle);
    std::vector<glm::vec3> points;
    for (const Sphere& one : randomSpheres(5000, 2, extent, middle)) points.push_back(one.center);
    std::vector<double> radii;
    for (const Sphere& sphere : spheres) radii.push_back(sphere.radius);
    std::size_t left = 0;
    for (const glm::vec3& point : points) {
      if (std::ranges::any_of(spheres, [&](const Sphere& s) { return contains(s, point); }))
        continue;
      const std::size_t s = cheapest(spheres, point);
      radii[s] = std::max(radii[s], distance(spheres[s], point));
      ++left;
    }
    CHECK(left > 100);

    const std::vector<Sphere> grown = grownToCover(spheres, points);
    REQUIRE(grown.size() == spheres.size());
    for (std::size_t s = 0; s < spheres.size(); ++s) {
      CHECK(grown[s].center == spheres[s].center);
      CHECK(grown[s].radius >= spheres[s].radius);
      CHECK(std::abs(grown[s].radius / radii[s] - 1) < 2e-6);
    }
    CHECK(std::ranges::all_of(points, [&](const glm::vec3& point) {
      return std::ranges::any_of(grown, [&](const Sphere& s) { return contains(s, point); });
    }));
  }
}

TEST_CASE("spheres that cover all points, or have none to cover, stay as they are") {
  const std::vector<Sphere> spheres = randomSpheres(10, 3);
  std::vector<glm::vec3> points;
  for (const Sphere& sphere : spheres)
    points.push_back(sphere.center + glm::vec3(0, sphere.radius * 0.99f, 0));
  for (const auto& covered : {points, std::vector<glm::vec3>{}}) {
    const std::vector<Sphere> grown = grownToCover(spheres, covered);
    for (std::size_t s = 0; s < spheres.size(); ++s) CHECK(grown[s].radius == spheres[s].radius);
  }
  CHECK(grownToCover({}, points).empty());
}

TEST_CASE("points within a sphere are spread evenly over it") {
  constexpr std::size_t count = 20000;
  const glm::vec3 center(5, -3, 2);
  const auto points = sampleInterior(sphereAt(center, 2, 4), count, 1);
  REQUIRE(points.size() == count);
  std::size_t outside = 0, octants[8] = {}, shells[10] = {};
  for (const glm::vec3& point : points) {
    const glm::vec3 offset = (point - center) / 2.0f;
    const float part = std::pow(glm::length(offset), 3.0f);  // of the volume that lies deeper
    outside += part > 1.0001f;
    ++octants[(offset.x > 0) + 2 * (offset.y > 0) + 4 * (offset.z > 0)];
    ++shells[std::min(int(part * 10), 9)];
  }
  CHECK(outside == 0);
  for (const std::size_t octant : octants)
    CHECK(std::abs(double(octant) - count / 8.0) < 5 * std::sqrt(count / 8.0));
  // The mesh lies within the ball by 0.4 % of its volume, all of it in the last shell.
  for (const std::size_t shell : shells)
    CHECK(std::abs(double(shell) - count / 10.0) < 5 * std::sqrt(count / 10.0));
}

TEST_CASE("points within a mesh: none of a sheet, few of a thin box, the same for a seed") {
  CHECK(sampleInterior(groundGrid(1, 4), 100, 1).empty());
  CHECK(sampleInterior({}, 100, 1).empty());
  CHECK(sampleInterior(torusKnot(), 0, 1).empty());
  // One that takes a small part of its bounding box: a long box across it.
  const TriangleMesh thin = transformed(box(glm::vec3(-1, -0.1f, -0.1f), glm::vec3(1, 0.1f, 0.1f)),
                                        glm::rotate(glm::mat4(1), 0.8f, glm::vec3(1, 2, 3)));
  const auto points = sampleInterior(thin, 3000, 7);
  CHECK(points.size() == 3000);
  CHECK(sampleInterior(thin, 3000, 7) == points);
  CHECK(sampleInterior(thin, 3000, 8) != points);
}
