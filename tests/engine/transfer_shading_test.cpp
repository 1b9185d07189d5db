#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <stdexcept>

#include "sh/zonal.h"
#include "test_scenes.h"
#include "test_transfer.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

bool sameBits(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

std::vector<glm::vec4> shadedBy(Engine& engine, const TestTransfer& transfer) {
  engine.setTransferRows(transfer.rows);
  engine.setTransferLights(transfer.lights);
  return engine.shadeByTransfer(transfer.receivers);
}

void checkAgreement(const std::string& engineName, const KernelShape& shape) {
  const auto engine = testEngine(engineName, VisibilityKind::exact, shape);
  if (!engine) return;
  const auto reference = referenceEngine();
  unsigned seed = 0;
  for (const int order : {1, 2, 3, 4, 5, 6, 7, 10, 20})
    for (const std::size_t receivers : {1, 31, 32, 33, 100})
      for (const std::size_t lights : {1, 2, 5}) {
        const int channels = ++seed % 2 ? 1 : 3;
        const bool blends = seed % 4 < 2;
        CAPTURE(order);
        CAPTURE(receivers);
        CAPTURE(lights);
        CAPTURE(channels);
        CAPTURE(blends);
        CAPTURE(shape.lanesPerItem);
        CAPTURE(shape.samplesPerGroup);
        const TestTransfer transfer =
            randomTransfer(seed, order, channels, receivers, lights, blends);
        REQUIRE(sameBits(shadedBy(*engine, transfer), shadedBy(*reference, transfer)));
      }
}

/// Rows of what faces the normals without any shadow: albedo/π times the clamped cosine.
TransferRows openRows(int order, std::span<const glm::dvec3> normals, const glm::vec3& albedo) {
  TransferRows rows{order, 3, {}};
  for (const glm::dvec3& normal : normals) {
    const auto cosine = rotateZonal(clampedCosineZonal(order), normal);
    for (int channel = 0; channel < 3; ++channel)
      for (int k = 0; k < cosine.size(); ++k)
        rows.values.push_back(albedo[channel] * float(cosine[k] / std::numbers::pi));
  }
  return rows;
}

/// The coefficients of light that is the same from everywhere.
TransferLights constantLights(int order, std::span<const glm::vec3> radiance) {
  TransferLights lights{order, {}};
  for (const glm::vec3& light : radiance)
    for (int channel = 0; channel < 3; ++channel)
      for (int k = 0; k < order * order; ++k)
        lights.values.push_back(k == 0 ? light[channel] * float(std::sqrt(4 * std::numbers::pi))
                                       : 0);
  return lights;
}

void checkClose(const glm::vec4& radiance, const glm::vec3& expected) {
  for (int channel = 0; channel < 3; ++channel)
    CHECK(radiance[channel] == doctest::Approx(expected[channel]).epsilon(1e-6));
  CHECK(radiance.w == 0);
}

const std::vector<glm::dvec3> normals{{0, 0, 1},
                                      {0, -1, 0},
                                      glm::normalize(glm::dvec3(1, 2, -3)),
                                      glm::normalize(glm::dvec3(-2, 1, 1))};

}  // namespace

TEST_CASE("by transfer reference and OpenCL agree in every bit, all lanes in an item") {
  checkAgreement("opencl", {32, 1});
  checkAgreement("opencl", {32, 3});
}

TEST_CASE("by transfer reference and OpenCL agree in every bit, a lane an item") {
  checkAgreement("opencl", {1, 1});
  checkAgreement("opencl", {1, 8});
}

TEST_CASE("by transfer reference and CUDA on the host agree in every bit") {
  checkAgreement("cuda-host", {1, 4});
  checkAgreement("cuda-host", {1, 3});
}

TEST_CASE("by transfer reference and CUDA agree in every bit") {
  checkAgreement("cuda", {1, 4});
  checkAgreement("cuda", {1, 8});
}

TEST_CASE("by transfer many receivers equal each of them alone") {
  for (const char* name : {"cuda-host", "opencl"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    for (const int order : {2, 5}) {
      const TestTransfer transfer = randomTransfer(7, order, 3, 5000, 2, true);
      const auto whole = shadedBy(*engine, transfer);
      for (const std::size_t i : {0u, 31u, 32u, 2048u, 4999u}) {
        const TransferReceivers one{
            {transfer.receivers.blends[i]},
            {transfer.receivers.lightWeights[2 * i], transfer.receivers.lightWeights[2 * i + 1]}};
        CHECK(sameBits(engine->shadeByTransfer(one), {whole[i]}));
      }
      CHECK(engine->shadeByTransfer({}).empty());
    }
  }
}

TEST_CASE(
    "open surfaces under light that is the same from everywhere have its radiance times albedo") {
  const glm::vec3 albedo(0.8f, 0.5f, 0.25f), light(3, 2, 1);
  const auto engine = referenceEngine();
  for (const int order : {1, 2, 3, 5, 8}) {
    engine->setTransferRows(openRows(order, normals, albedo));
    engine->setTransferLights(constantLights(order, std::span(&light, 1)));
    TransferReceivers receivers;
    for (std::uint32_t i = 0; i < normals.size(); ++i)
      receivers.blends.push_back({{i, 0, 0, 0}, {1, 0, 0, 0}});
    receivers.blends.push_back({{0, 1, 2, 0}, {0.25f, 0.25f, 0.5f, 0}});
    receivers.lightWeights.assign(receivers.size(), 1);
    for (const glm::vec4& radiance : engine->shadeByTransfer(receivers))
      checkClose(radiance, albedo * light);
  }
}

TEST_CASE("several lights are blended by the receiver's weights") {
  const std::vector<glm::vec3> lights{{3, 2, 1}, {0, 1, 4}, {1, 1, 1}};
  const auto engine = referenceEngine();
  engine->setTransferRows(openRows(4, normals, glm::vec3(1)));
  engine->setTransferLights(constantLights(4, lights));
  const auto shaded =
      engine->shadeByTransfer({{{{1, 0, 0, 0}}, {{2, 0, 0, 0}}}, {0.5f, 0.25f, 0.25f, 0, 1, 0}});
  checkClose(shaded[0], 0.5f * lights[0] + 0.25f * lights[1] + 0.25f * lights[2]);
  checkClose(shaded[1], lights[1]);
}

TEST_CASE("rows of one channel are those of three equal ones") {
  const auto engine = referenceEngine();
  for (const int order : {2, 5}) {
    TestTransfer transfer = randomTransfer(3, order, 1, 40, 2, true);
    const auto grey = shadedBy(*engine, transfer);
    const TransferRows one = std::exchange(transfer.rows, {order, 3, {}});
    for (std::size_t row = 0; row < one.rowCount(); ++row)
      for (int channel = 0; channel < 3; ++channel)
        for (const float value : one.row(row, channel)) transfer.rows.values.push_back(value);
    CHECK(sameBits(shadedBy(*engine, transfer), grey));
  }
}

TEST_CASE("radiance is never below zero, and zero has no sign") {
  for (const char* name : {"reference", "cuda-host", "opencl"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    for (const int order : {1, 2, 3}) {
      TransferRows rows{order, 1, std::vector<float>(std::size_t(order * order), 0.0f)};
      const glm::vec3 light(-1, 2, 1e-30f);
      rows.values[0] = 1e-30f;
      engine->setTransferRows(rows);
      engine->setTransferLights(constantLights(order, std::span(&light, 1)));
      const glm::vec4 radiance = engine->shadeByTransfer({{{}}, {1}})[0];
      CHECK(radiance.x == 0);
      CHECK(!std::signbit(radiance.x));
      CHECK(radiance.y > 0);
      const glm::vec3 smaller(-1e-30f);
      engine->setTransferLights(constantLights(order, std::span(&smaller, 1)));
      CHECK(!std::signbit(engine->shadeByTransfer({{{}}, {1}})[0].x));
    }
  }
}

TEST_CASE("rows, lights and receivers that do not go together are refused") {
  for (const char* name : {"reference", "cuda-host"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    TestTransfer transfer = randomTransfer(1, 3, 1, 4, 2, true);
    engine->setTransferRows(transfer.rows);
    engine->setTransferLights(randomTransfer(1, 4, 1, 4, 2, true).lights);
    CHECK_THROWS_AS(engine->shadeByTransfer(transfer.receivers), std::invalid_argument);
    engine->setTransferLights({3, {}});
    CHECK_THROWS_AS(engine->shadeByTransfer(transfer.receivers), std::invalid_argument);
    engine->setTransferLights(transfer.lights);
    CHECK(engine->shadeByTransfer(transfer.receivers).size() == 4);
    TransferReceivers few = transfer.receivers, beyond = transfer.receivers;
    few.lightWeights.pop_back();
    CHECK_THROWS_AS(engine->shadeByTransfer(few), std::invalid_argument);
    beyond.blends[2].rows.z = std::uint32_t(transfer.rows.rowCount());
    CHECK_THROWS_AS(engine->shadeByTransfer(beyond), std::invalid_argument);
  }
}
