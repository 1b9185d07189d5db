#include "transfer/light_transport.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "sh/quadrature.h"
#include "sh/rotation.h"
#include "sh/zonal.h"
#include "transfer_meshes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr int order = 5;
constexpr int row = order * order;

std::vector<float> ones(const TriangleMesh& mesh) {
  return std::vector<float>(mesh.positions.size(), 1.0f);
}

/// A vertex at the origin of a floor that faces +z, in front of a long wall of unit width: at x =
/// 1, y to ±1000, z from 0 to `height`, facing −x.
TriangleMesh floorAndWall(float height) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0},    {-1, -1, 0},       {-1, 1, 0},        {1, -1000, 0},
                    {1, 1000, 0}, {1, 1000, height}, {1, -1000, height}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.normals.resize(7, {-1, 0, 0});
  mesh.triangles = {{0, 2, 1}, {3, 6, 5}, {3, 5, 4}};
  return mesh;
}

/// 1/π ∫ cos y over the directions that the wall blocks, and the same with y²: azimuth by azimuth
/// the wall reaches up to a known height.
struct Moments {
  std::vector<double> mean = std::vector<double>(row), square = std::vector<double>(row);
  double height = 0;  ///< 1/π ∫ cos h, h the height at which the wall is seen
};

Moments blockedByWall(double height) {
  constexpr int azimuths = 4000;
  const GaussLegendreRule rule = gaussLegendre(16);
  const double widest = std::atan(1000.0);
  Moments moments;
  std::vector<double> basis(row);
  for (int i = 0; i < azimuths; ++i) {
    const double azimuth = widest * (2 * (i + 0.5) / azimuths - 1);
    const double slope = height * std::cos(azimuth), top = slope / std::hypot(1, slope);
    for (int k = 0; k < 16; ++k) {
      const double z = top * (rule.nodes[k] + 1) / 2, s = std::sqrt(1 - z * z);
      const double weight = rule.weights[k] * top / 2 * 2 * widest / azimuths * z / pi;
      evaluateShBasis<double>(order, {s * std::cos(azimuth), s * std::sin(azimuth), z}, basis);
      moments.height += weight * z / (s * std::cos(azimuth));
      for (int j = 0; j < row; ++j) {
        moments.mean[j] += weight * basis[j];
        moments.square[j] += weight * basis[j] * basis[j];
      }
    }
  }
  return moments;
}

double largestDifference(std::span<const float> values, double expected) {
  double largest = 0;
  for (const float value : values) largest = std::max(largest, std::abs(value - expected));
  return largest;
}

}  // namespace

TEST_CASE("unshadowed transfer is the clamped cosine about the normal") {
  // By quadrature, and turned by the rotation of any function instead of that of zonal ones.
  const TriangleMesh sphere = icosphere(1);
  const std::vector<float> transfer = unshadowedTransfer(sphere.normals, order);
  const std::vector<double> zonal = projectZonal(
      order, [](double cosine) { return cosine; }, 0, 1);
  ShVector<double> lobe(order);
  for (int l = 0; l < order; ++l) lobe.at(l, 0) = zonal[l] / pi;
  for (std::size_t v = 0; v < sphere.normals.size(); ++v) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(sphere.normals[v]));
    const glm::dvec3 across = glm::normalize(
        glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const ShVector<double> turned =
        ShRotation(glm::dmat3(across, glm::cross(n, across), n), order)(lobe);
    for (int i = 0; i < row; ++i)
      CHECK(transfer[v * row + i] == doctest::Approx(turned[i]).epsilon(1e-6).scale(1));
  }
}

TEST_CASE("a convex mesh does not shadow itself") {
  const TriangleMesh far = [] {
    TriangleMesh mesh = faceted(icosphere(2));
    for (glm::vec3& p : mesh.positions) p = 0.01f * p + glm::vec3(30, -20, 10);
    return mesh;
  }();
  for (const TriangleMesh& mesh : {icosphere(3), faceted(icosphere(2)),
                                   faceted(box({0, 0, 0}, {1, 2, 3})), groundGrid(3, 8), far}) {
    const LightTransport transport(mesh, order, 256, 1, true);
    CHECK(transport.blockedPart() == 0);
    CHECK(transport.direct() == unshadowedTransfer(mesh.normals, order));
    CHECK(transport.reflected(ones(mesh), 1) == std::vector<float>(mesh.positions.size(), 0.0f));
  }
}

TEST_CASE("a wall takes from the transfer what it hides, in closed form") {
  constexpr int rays = 4096;
  for (const float height : {0.5f, 1.0f, 3.0f}) {
    const TriangleMesh mesh = floorAndWall(height);
    const Moments blocked = blockedByWall(height);
    // The view factor of a strip without end, but for its ends at 1000.
    const double factor = 0.5 * (1 - 1 / std::hypot(1, height));
    CHECK(blocked.mean[0] == doctest::Approx(factor / std::sqrt(4 * pi)).epsilon(1e-4));
    const std::vector<float> open = unshadowedTransfer(mesh.normals, order);
    std::vector<float> heights;
    for (const glm::vec3& p : mesh.positions) heights.push_back(p.z);
    double squared = 0, independent = 0;
    constexpr int seeds = 20;
    for (int seed = 0; seed < seeds; ++seed) {
      const LightTransport transport(mesh, order, rays, seed, true);
      for (int i = 0; i < row; ++i) {
        const double variance = blocked.square[i] - blocked.mean[i] * blocked.mean[i];
        const double error = open[i] - blocked.mean[i] - transport.direct()[i];
        CHECK(std::abs(error) <= 2 * std::sqrt(variance / rays) + 1e-6);
        squared += error * error;
        independent += variance / rays;
      }
      // The wall reflects as much as it hides, and what grows with its height by its height.
      CHECK(transport.reflected(ones(mesh), 1)[0] == doctest::Approx(factor).epsilon(0.01));
    }
    MESSAGE("wall of height ", height, ", ", rays, " rays: root mean square error ",
            std::sqrt(squared / (seeds * row)), ", of independent rays ",
            std::sqrt(independent / (seeds * row)));
    CHECK(squared < independent / 16);
  }
}

TEST_CASE("faces block from both sides and reflect from the side of their normals") {
  const TriangleMesh mesh = floorAndWall(1);
  TriangleMesh wound = mesh, faced = mesh;
  for (std::size_t t = 1; t < mesh.triangles.size(); ++t)
    std::swap(wound.triangles[t].y, wound.triangles[t].z);
  for (std::size_t v = 3; v < mesh.normals.size(); ++v) faced.normals[v] = {1, 0, 0};
  const LightTransport transport(mesh, order, 512, 1, true),
      woundAgainst(wound, order, 512, 1, true), facingAway(faced, order, 512, 1, true);
  const auto first = [](const std::vector<float>& values) {
    return std::vector(values.begin(), values.begin() + row);
  };
  CHECK(woundAgainst.direct() == transport.direct());
  CHECK(woundAgainst.reflected(ones(mesh), 1) == transport.reflected(ones(mesh), 1));
  CHECK(first(facingAway.direct()) == first(transport.direct()));
  CHECK(transport.reflected(ones(mesh), 1)[0] > 0.1f);
  CHECK(facingAway.reflected(ones(mesh), 1)[0] == 0);
}

TEST_CASE("no light comes into a closed room, and all that leaves its walls meets them again") {
  for (const TriangleMesh& mesh : {room(), fromWithin(icosphere(2))}) {
    const LightTransport transport(mesh, order, 512, 1, true);
    CHECK(transport.blockedPart() == 1);
    CHECK(largestDifference(transport.direct(), 0) == 0);
    CHECK(largestDifference(transport.reflected(ones(mesh), 1), 1) < 1e-6);
  }
}

TEST_CASE("in a sphere every point receives the mean of all") {
  const TriangleMesh mesh = fromWithin(icosphere(4));
  constexpr int rays = 1024;
  const LightTransport transport(mesh, order, rays, 1, true);
  // Three functions a vertex: z with mean 0, z² with mean 1/3, and 5.
  std::vector<float> values;
  for (const glm::vec3& p : mesh.positions) values.insert(values.end(), {p.z, p.z * p.z, 5.0f});
  const std::vector<float> received = transport.reflected(values, 3);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    // Standard deviation of z is 1/√3, of z² √(4/45): 5 standard errors of independent rays. The
    // chords' points lie up to 0.3 % within the sphere.
    CHECK(std::abs(received[3 * v]) < 5 / std::sqrt(3.0 * rays));
    CHECK(std::abs(received[3 * v + 1] - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / rays) + 0.003);
    CHECK(received[3 * v + 2] == doctest::Approx(5).epsilon(1e-6));
  }
}

TEST_CASE("the result is the same on any number of threads") {
  const TriangleMesh knot = torusKnot({.lengthSegments = 64, .tubeSegments = 12});
  std::vector<float> direct, reflected;
  for (const unsigned threads : {1u, 2u, 5u}) {
    setThreadCount(threads);
    const LightTransport transport(knot, order, 100, 1, true);
    const std::vector<float> bounce = transport.reflected(transport.direct(), row);
    if (threads == 1) direct = transport.direct(), reflected = bounce;
    CHECK(transport.direct() == direct);
    CHECK(bounce == reflected);
  }
  setThreadCount(0);
  CHECK(LightTransport(knot, order, 100, 2, true).direct() != direct);
}

TEST_CASE("what cannot be transported is refused") {
  TriangleMesh mesh = icosphere(1);
  const LightTransport shadowed(mesh, order, 4, 1, false);
  CHECK_THROWS_AS(shadowed.reflected(ones(mesh), 1), std::invalid_argument);
  const LightTransport transport(mesh, order, 4, 1, true);
  CHECK_THROWS_AS(transport.reflected(ones(mesh), 2), std::invalid_argument);
  CHECK_THROWS_AS(LightTransport(mesh, 0, 4, 1, true), std::invalid_argument);
  CHECK_THROWS_AS(LightTransport(mesh, order, 0, 1, true), std::invalid_argument);
  mesh.normals.clear();
  CHECK_THROWS_AS(LightTransport(mesh, order, 4, 1, true), std::invalid_argument);
}

TEST_CASE("of a mesh whose first vertices alone are asked for, all triangles block") {
  const TriangleMesh mesh = floorAndWall(2);
  const LightTransport whole(mesh, order, 256, 3, false), first(mesh, order, 256, 3, false, {}, 2);
  CHECK(first.direct() ==
        std::vector<float>(whole.direct().begin(), whole.direct().begin() + 2 * row));
  CHECK(first.direct() != unshadowedTransfer(std::span(mesh.normals).first(2), order));
  CHECK_THROWS_AS(LightTransport(mesh, order, 16, 3, false, {}, 8), std::invalid_argument);
  CHECK_THROWS_AS(LightTransport(mesh, order, 16, 3, true, {}, 2), std::invalid_argument);
}
