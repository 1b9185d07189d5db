#include "spheres/viewpoints.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>
#include <vector>

#include "spheres/random_spheres.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Largest distance of the distribution of the values from the even one on 0 … 1.
double unevenness(std::vector<double> values) {
  std::ranges::sort(values);
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    largest = std::max({largest, std::abs(values[i] - double(i) / double(values.size())),
                        std::abs(values[i] - double(i + 1) / double(values.size()))});
  return largest;
}

glm::dvec3 mean(const std::vector<glm::dvec3>& vectors) {
  return std::accumulate(vectors.begin(), vectors.end(), glm::dvec3(0)) / double(vectors.size());
}

}  // namespace

TEST_CASE("a basis around a vector is right-handed and orthonormal") {
  Random random(1);
  std::vector<glm::dvec3> axes = {{0, 0, 1},    {0, 0, -1},
                                  {1, 0, 0},    {0, -1, 0},
                                  {0, 1, -0.0}, glm::normalize(glm::dvec3(1e-9, -1e-9, -1))};
  for (int i = 0; i < 200; ++i) axes.push_back(randomDirection(random));
  for (const glm::dvec3& axis : axes) {
    const glm::dmat3 basis = basisAround(axis), product = glm::transpose(basis) * basis;
    CHECK(basis[2] == axis);
    CHECK(std::abs(glm::determinant(basis) - 1) < 1e-14);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) CHECK(std::abs(product[i][j] - (i == j)) < 1e-14);
  }
}

TEST_CASE("directions in a cap lie in it and are spread evenly") {
  Random random(2);
  constexpr std::size_t count = 2000;
  for (const double cosine : {-1.0, -0.3, 0.5, 0.99}) {
    const glm::dvec3 axis = randomDirection(random);
    const auto directions = directionsInCap(3.0 * axis, cosine, count, random.uniform());
    REQUIRE(directions.size() == count);
    std::vector<double> heights;
    for (const glm::dvec3& direction : directions) {
      CHECK(std::abs(glm::length(direction) - 1) < 1e-14);
      heights.push_back((glm::dot(direction, axis) - cosine) / (1 - cosine));
    }
    // Areas between parallel planes are as their distances (Archimedes).
    CHECK(unevenness(heights) < 1.0 / count);
    const double radius = std::sqrt(1 - std::min(cosine * std::abs(cosine), 1.0));
    CHECK(glm::distance(mean(directions), (1 + cosine) / 2 * axis) < 0.002 * radius);
  }
}

TEST_CASE("every cap of the sphere has its part of an even set of directions") {
  Random random(3);
  constexpr std::size_t count = 2000;
  const auto directions = directionsInCap({1, 2, 3}, -1, count, 0.3);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 axis = randomDirection(random);
    const double cosine = 2 * random.uniform() - 1;
    const auto within = std::ranges::count_if(
        directions, [&](const glm::dvec3& d) { return glm::dot(d, axis) > cosine; });
    // Random directions would miss by up to 0.02.
    CHECK(std::abs(double(within) / count - (1 - cosine) / 2) < 0.004);
  }
}

TEST_CASE("a turn of a lattice turns it around its axis") {
  const glm::dvec3 axis(0, 0, 1);
  const auto still = directionsInCap(axis, 0.2, 50, 0),
             turned = directionsInCap(axis, 0.2, 50, 0.25);
  for (std::size_t i = 0; i < 50; ++i)  // a quarter
    CHECK(glm::distance(turned[i], glm::dvec3(-still[i].y, still[i].x, still[i].z)) < 1e-12);
  CHECK(directionsInCap(axis, 0, 0, 0).empty());
}

TEST_CASE("viewpoints stand in all directions and at all distances alike") {
  const BoundingBox box{{-1, 2, 3}, {3, 4, 7}};  // half its diagonal is 3
  const glm::dvec3 center(1, 3, 5);
  constexpr std::size_t count = 1600;
  for (const std::uint64_t seed : {0, 1, 2}) {
    const auto viewpoints = viewpointsAround(box, count, seed, {2, 5});
    REQUIRE(viewpoints.size() == count);
    std::vector<double> all, octants[8];
    std::vector<glm::dvec3> directions;
    for (const glm::dvec3& viewpoint : viewpoints) {
      const glm::dvec3 offset = viewpoint - center;
      const double distance = glm::length(offset), part = (distance / 3 - 2) / 3;
      CHECK(part >= -1e-12);
      CHECK(part <= 1 + 1e-12);
      all.push_back(part);
      octants[(offset.x > 0) + 2 * (offset.y > 0) + 4 * (offset.z > 0)].push_back(part);
      directions.push_back(offset / distance);
    }
    CHECK(unevenness(all) < 0.005);
    CHECK(glm::length(mean(directions)) < 0.001);
    for (const std::vector<double>& octant : octants) {
      CHECK(std::abs(double(octant.size()) - count / 8.0) < 10);
      CHECK(unevenness(octant) < 0.045);  // of random distances: 0.06 on average
    }
  }
}

TEST_CASE("viewpoints follow the box, and their directions the seed") {
  const BoundingBox box{{-1, -1, -1}, {1, 1, 1}}, other{{4, 4, 4}, {12, 12, 12}};
  const auto viewpoints = viewpointsAround(box, 20, 5), again = viewpointsAround(box, 20, 5);
  const auto moved = viewpointsAround(other, 20, 5), turned = viewpointsAround(box, 20, 6);
  CHECK(viewpoints == again);
  for (std::size_t i = 0; i < 20; ++i) {
    CHECK(glm::distance(moved[i], 4.0 * viewpoints[i] + 8.0) < 1e-12);
    CHECK(glm::distance(turned[i], viewpoints[i]) > 0.01);
    const double multiple = glm::length(viewpoints[i]) / std::sqrt(3.0);
    CHECK(multiple >= ViewpointRange{}.nearest);
    CHECK(multiple <= ViewpointRange{}.farthest);
  }
}
