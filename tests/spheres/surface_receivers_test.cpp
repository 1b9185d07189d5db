#include "spheres/surface_receivers.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "test_support.h"

using namespace haarlight;

namespace {

constexpr std::size_t manyReceivers = 200000;

/// For the unit sphere and a ball on the z axis: the mean over the sphere, by the midpoint rule
/// over z, whose slices have equal areas.
double blockedOnUnitSphere(double height, double radius) {
  constexpr int slices = 200000;
  double sum = 0;
  for (int i = 0; i < slices; ++i) {
    const double z = -1 + 2 * (i + 0.5) / slices;
    // |c − p|² and (c − p)·p for c on the axis and p on the sphere.
    const double distance = std::sqrt(height * height - 2 * height * z + 1);
    if (distance > radius) continue;
    const double cosine = (height * z - 1) / distance;
    sum += cosine >= 0 ? (1 + cosine) / 2 : std::max(0.0, 1 - 16 * cosine * cosine) / 2;
  }
  return sum / slices;
}

}  // namespace

TEST_CASE("a ball around the middle of a body takes nothing from its surface") {
  const SurfaceReceivers receivers(icosphere(4), 20000, 1);
  CHECK(receivers.blockedBy({glm::dvec3(0), 1.2}) == 0);
  CHECK(receivers.blockedBy({glm::dvec3(0), 0.5}) == 0);
  CHECK(receivers.blockedBy({glm::dvec3(0, 0, 5), 1}) == 0);
  CHECK(receivers.blockedBy({glm::dvec3(0), -1}) == 0);
}

TEST_CASE("a ball beside the body takes what the integral over the sphere says") {
  const SurfaceReceivers receivers(icosphere(6), manyReceivers, 2);
  for (const auto& [height, radius] : {std::pair{1.5, 1.0}, {1.1, 0.5}, {2.5, 2.0}, {1.0, 0.6}}) {
    const double expected = blockedOnUnitSphere(height, radius);
    REQUIRE(expected > 0.001);
    CHECK(std::abs(receivers.blockedBy({glm::dvec3(0, 0, height), radius}) - expected) <
          0.02 * expected);
    CHECK(std::abs(receivers.blockedBy({glm::dvec3(0, height, 0), radius}) - expected) <
          0.02 * expected);
  }
}

TEST_CASE("a centre on a receiver has no direction and counts nothing") {
  TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}};
  const SurfaceReceivers one(triangle, 1, 3);
  const glm::dvec3 receiver = sampleSurface(triangle, 1, 3)[0];
  CHECK(one.blockedBy({receiver, 0.5}) == 0);
  CHECK(one.blockedBy({receiver + glm::dvec3(0, 0, 0.25), 0.5}) == doctest::Approx(1));
  CHECK(one.blockedBy({receiver + glm::dvec3(0.25, 0, 0), 0.5}) == doctest::Approx(0.5));
  CHECK(one.blockedBy({receiver - glm::dvec3(0, 0, 0.25), 0.5}) == 0);
}
