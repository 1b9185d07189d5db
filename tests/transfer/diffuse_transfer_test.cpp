#include "transfer/diffuse_transfer.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/mesh_file.h"
#include "mesh/mesh_measures.h"
#include "test_support.h"
#include "transfer_meshes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Mean over the surface of what leaves it under light of radiance 1 from everywhere.
double underUniformLight(const DiffuseTransfer& transfer, std::size_t vertex) {
  return std::sqrt(4 * std::numbers::pi) * transfer.row(vertex)[0];
}

TransferOptions options(TransferKind kind, int bounces = 0, const glm::vec3& albedo = glm::vec3(1),
                        int rays = 256) {
  return {.kind = kind, .order = 4, .bounces = bounces, .raysPerVertex = rays, .albedo = albedo};
}

}  // namespace

TEST_CASE("the radiance of an open surface under uniform light is its albedo") {
  const TriangleMesh sphere = icosphere(2);
  for (const TransferKind kind :
       {TransferKind::unshadowed, TransferKind::shadowed, TransferKind::interreflected}) {
    const TransferResult result = computeTransfer(sphere, options(kind, 2, glm::vec3(0.75f)));
    CHECK(result.transfer.kind == kind);
    CHECK(result.transfer.channels == 1);
    CHECK(result.transfer.vertices == sphere.positions.size());
    CHECK(result.transfer.values.size() == 16 * sphere.positions.size());
    CHECK(result.transfer.meshHash == meshHash(sphere));
    for (std::size_t v = 0; v < sphere.positions.size(); ++v)
      CHECK(underUniformLight(result.transfer, v) == doctest::Approx(0.75).epsilon(1e-6));
    CHECK(result.energyByBounce.front().y == doctest::Approx(0.75).epsilon(1e-6));
  }
}

TEST_CASE("in a bowl bounce after bounce has the energy of an integrating sphere") {
  // From every point of a sphere, every part of the sphere is seen with the part of its area. So
  // half of the light that leaves a half sphere meets it again, everywhere the same: bounce b has
  // a (a/2)^b / 2. Chords for arcs change view factors by some tenths of a percent.
  constexpr int bounces = 6;
  constexpr float albedo = 0.8f;
  const TriangleMesh mesh = fromWithin(bowl(64));
  const TransferResult result =
      computeTransfer(mesh, options(TransferKind::interreflected, bounces, glm::vec3(albedo), 512));
  REQUIRE(result.energyByBounce.size() == bounces + 1);
  double expected = albedo / 2, sum = 0;
  for (const glm::vec3& energy : result.energyByBounce) {
    CHECK(energy.x == doctest::Approx(expected).epsilon(0.01));
    sum += expected;
    expected *= albedo / 2;
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(underUniformLight(result.transfer, v) == doctest::Approx(sum).epsilon(0.05));
}

TEST_CASE("in a closed white room no energy is lost: bounces add up to 1/(1 − a)") {
  const TriangleMesh mesh = room();
  const LightTransport transport(mesh, 1, 128, 1, true);
  constexpr double albedo = 0.6;
  std::vector<float> emitted(mesh.positions.size(), 1.0f);
  double sum = 1;
  for (int bounce = 1; bounce <= 20; ++bounce) {
    emitted = transport.reflected(emitted, 1);
    for (float& value : emitted) value *= float(albedo);
    for (const float value : emitted)
      REQUIRE(value == doctest::Approx(std::pow(albedo, bounce)).epsilon(1e-5));
    sum += emitted.front();
  }
  CHECK(sum == doctest::Approx(1 / (1 - albedo)).epsilon(1e-4));
}

TEST_CASE("transfer is a power series in the albedo that begins with the shadowed one") {
  const TriangleMesh knot = torusKnot({.lengthSegments = 48, .tubeSegments = 8});
  const auto values = [&](TransferKind kind, float albedo) {
    return computeTransfer(knot, options(kind, 2, glm::vec3(albedo))).transfer.values;
  };
  const std::vector<float> black = values(TransferKind::interreflected, 0),
                           shadowed = values(TransferKind::shadowed, 1);
  CHECK(black == std::vector<float>(black.size(), 0.0f));
  // Both with an albedo a: what is more is a² G_1 + a³ G_2, at most a² (1 + a) by conservation.
  constexpr float albedo = 1.0f / 64;
  const std::vector<float> dark = values(TransferKind::interreflected, albedo);
  double largest = 0;
  for (std::size_t i = 0; i < dark.size(); ++i)
    largest = std::max(largest, std::abs(double(dark[i]) / albedo - shadowed[i]));
  CHECK(largest < albedo * (1 + albedo));
  CHECK(largest > albedo / 100);
}

TEST_CASE("a coloured albedo has in each channel the transfer of that grey") {
  const TriangleMesh knot = torusKnot({.lengthSegments = 48, .tubeSegments = 8});
  const glm::vec3 albedo(0.9f, 0.5f, 0.1f);
  const TransferResult colored =
      computeTransfer(knot, options(TransferKind::interreflected, 3, albedo));
  REQUIRE(colored.transfer.channels == 3);
  for (int channel = 0; channel < 3; ++channel) {
    const TransferResult grey =
        computeTransfer(knot, options(TransferKind::interreflected, 3, glm::vec3(albedo[channel])));
    REQUIRE(3 * grey.transfer.values.size() == colored.transfer.values.size());
    for (std::size_t i = 0; i < grey.transfer.values.size(); ++i)
      REQUIRE(colored.transfer.values[3 * i + channel] == grey.transfer.values[i]);
    for (std::size_t bounce = 0; bounce < 4; ++bounce)
      CHECK(colored.energyByBounce[bounce][channel] == grey.energyByBounce[bounce].x);
  }
}

TEST_CASE("energy falls with each bounce, also for white") {
  const TransferResult result =
      computeTransfer(torusKnot(), options(TransferKind::interreflected, 5));
  REQUIRE(result.energyByBounce.size() == 6);
  double sum = 0;
  for (std::size_t bounce = 0; bounce < 6; ++bounce) {
    sum += result.energyByBounce[bounce].x;
    CHECK(result.energyByBounce[bounce].x > 0);
    if (bounce > 0)
      CHECK(result.energyByBounce[bounce].x < result.energyByBounce[bounce - 1].x / 2);
  }
  // White in uniform light approaches the light's radiance from below.
  CHECK(sum < 1);
  CHECK(sum > 0.95);
}

TEST_CASE("a computation ends when its monitor says so") {
  std::atomic<int> reports = 0;
  const TransferMonitor monitor{[&](const std::string&, double finished) {
                                  CHECK(finished > 0);
                                  CHECK(finished <= 1);
                                  ++reports;
                                },
                                [&] { return reports > 3; }};
  CHECK_THROWS_AS(computeTransfer(torusKnot(), options(TransferKind::interreflected, 2), monitor),
                  TransferCancelled);
  CHECK(reports > 3);
  CHECK(reports < 50);  // of 97 ranges of vertices
}

TEST_CASE("options out of range are refused") {
  const TriangleMesh sphere = icosphere(0);
  const auto refused = [&](const auto& change) {
    TransferOptions changed = options(TransferKind::interreflected, 1);
    change(changed);
    CHECK_THROWS_AS(computeTransfer(sphere, changed), std::invalid_argument);
  };
  refused([](TransferOptions& o) { o.order = 0; });
  refused([](TransferOptions& o) { o.order = maximumTransferOrder + 1; });
  refused([](TransferOptions& o) { o.bounces = 0; });
  refused([](TransferOptions& o) { o.bounces = maximumTransferBounces + 1; });
  refused([](TransferOptions& o) { o.raysPerVertex = 0; });
  refused([](TransferOptions& o) { o.raysPerVertex = maximumTransferRays + 1; });
  refused([](TransferOptions& o) { o.albedo.y = 1.1f; });
  refused([](TransferOptions& o) { o.albedo.z = std::numeric_limits<float>::quiet_NaN(); });
}

TEST_CASE("on the whole bunny every bounce brings much less than the one before") {
  const auto path = testData("meshes/bunny.obj");
  if (!path) return;
  const LoadedMesh bunny = loadMesh(*path);
  REQUIRE(bunny.mesh.positions.size() == 35947);
  const TransferResult result = computeTransfer(bunny.mesh, {});
  CHECK(result.transfer.values.size() == std::size_t(25) * 35947);
  REQUIRE(result.energyByBounce.size() == 3);
  CHECK(result.energyByBounce[0].x < 0.5);
  CHECK(result.energyByBounce[0].x > 0.3);
  for (int bounce = 1; bounce < 3; ++bounce)
    CHECK(result.energyByBounce[bounce].x < result.energyByBounce[bounce - 1].x / 4);
}
