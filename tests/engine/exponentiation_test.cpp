#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "cube/cube_map.h"
#include "sh/projection.h"
#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr double pi = std::numbers::pi;

bool sameBits(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

ExponentiationTables lowOrderTables(const TestScene& scene, int order) {
  return buildExponentiationTables(scene.light, order, countLobes(scene.receivers.lobes));
}

TestScene sceneWithSpheres(unsigned seed, std::size_t count, int receivers = 8) {
  TestScene scene = randomScene(seed, receivers);
  for (unsigned more = 1000; scene.spheres.size() < count; ++more) {
    const auto others = randomScene(seed + more, receivers).spheres;
    scene.spheres.insert(scene.spheres.end(), others.begin(), others.end());
  }
  scene.spheres.resize(count);
  return scene;
}

void checkRadiance(Engine& engine, const TestScene& scene, int order) {
  const ExponentiationTables tables = lowOrderTables(scene, order);
  const auto reference = referenceEngine();
  reference->setExponentiation(tables);
  engine.setExponentiation(tables);
  const auto expected = reference->shadeByExponentiation(scene.spheres, scene.receivers);
  for (const glm::vec4& radiance : expected)
    for (int channel = 0; channel < 3; ++channel) REQUIRE(radiance[channel] >= 0);
  REQUIRE(sameBits(engine.shadeByExponentiation(scene.spheres, scene.receivers), expected));
}

void checkAgreement(const std::string& engineName, const KernelShape& shape) {
  const auto engine = testEngine(engineName, VisibilityKind::exact, shape);
  if (!engine) return;
  unsigned seed = 0;
  for (const int order : {4, 5, 6, 2, 3})
    for (const std::size_t spheres : {0, 1, 31, 32, 33, 64, 256}) {
      CAPTURE(order);
      CAPTURE(spheres);
      CAPTURE(shape.lanesPerItem);
      CAPTURE(shape.samplesPerGroup);
      checkRadiance(*engine, sceneWithSpheres(++seed, spheres), order);
    }
}

/// A light with all lobes, receivers that look in all directions.
TestScene openScene() {
  TestScene scene = randomScene(11, 40);
  scene.spheres.clear();
  return scene;
}

/// A receiver at the origin that looks along +z, under a light that is 1 everywhere but for red.
TestScene zenithScene() {
  TestScene scene;
  scene.receivers.add({0, 0, 0}, {0, 0, 1});
  for (int texel = 0; texel < texelCount; ++texel) {
    const glm::dvec3 d = texelDirection(texel);
    scene.light[texel] = glm::vec3(1 + d.x, 1, std::max(d.z, 0.0));
  }
  return scene;
}

glm::vec3 shadedByReference(const TestScene& scene, int order) {
  const auto engine = referenceEngine();
  engine->setExponentiation(lowOrderTables(scene, order));
  return engine->shadeByExponentiation(scene.spheres, scene.receivers)[0];
}

/// ∫ light · cosine/π · V over directions, with V the projection of what the spheres leave open,
/// all by quadrature in double.
glm::dvec3 shadedByProjection(const TestScene& scene, int order) {
  const auto open = projectToSh(order, productRule(200, 400), [&](const glm::dvec3& direction) {
    for (const Sphere& sphere : scene.spheres) {
      const glm::dvec3 center(sphere.center);
      const double along = glm::dot(direction, center);
      if (along > 0 && along * along >= glm::dot(center, center) - sphere.radius * sphere.radius)
        return 0.0;
    }
    return 1.0;
  });
  glm::dvec3 radiance(0);
  for (const auto& [direction, weight] : productRule(100, 200)) {
    const double lobe = std::max(direction.z, 0.0) / pi * weight * evaluate(open, direction);
    radiance += lobe * glm::dvec3(1 + direction.x, 1, std::max(direction.z, 0.0));
  }
  return radiance;
}

Sphere sphereAt(double polarDegrees, double azimuthDegrees, double radiusDegrees) {
  const double theta = polarDegrees * pi / 180, phi = azimuthDegrees * pi / 180;
  const glm::dvec3 direction(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
  return {glm::vec3(4.0 * direction), float(4 * std::sin(radiusDegrees * pi / 180))};
}

double largestError(const TestScene& scene, int order) {
  const glm::dvec3 error =
      glm::dvec3(shadedByReference(scene, order)) - shadedByProjection(scene, order);
  return std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)});
}

}  // namespace

TEST_CASE("by exponentiation reference and OpenCL agree in every bit, all lanes in an item") {
  checkAgreement("opencl", {32, 1});
  checkAgreement("opencl", {32, 3});
}

TEST_CASE("by exponentiation reference and OpenCL agree in every bit, a lane an item") {
  checkAgreement("opencl", {1, 1});
  checkAgreement("opencl", {1, 8});
}

TEST_CASE("by exponentiation reference and CUDA on the host agree in every bit") {
  checkAgreement("cuda-host", {1, 4});
  checkAgreement("cuda-host", {1, 3});
}

TEST_CASE("by exponentiation reference and CUDA agree in every bit") {
  checkAgreement("cuda", {1, 4});
  checkAgreement("cuda", {1, 8});
}

TEST_CASE("by exponentiation a frame equals its receivers one by one") {
  for (const char* name : {"cuda-host", "opencl"}) {
    const auto engine = testEngine(name);
    if (!engine) return;
    const TestScene scene = sceneWithSpheres(7, 40, 600);
    engine->setExponentiation(lowOrderTables(scene, 4));
    const auto whole = engine->shadeByExponentiation(scene.spheres, scene.receivers);
    for (const std::size_t i : {0u, 15u, 16u, 255u, 599u}) {
      const auto part = ReceiverSpan(scene.receivers).part(i, 1);
      CHECK(sameBits(engine->shadeByExponentiation(scene.spheres, part), {whole[i]}));
    }
    CHECK(engine->shadeByExponentiation(scene.spheres, Receivers{}).empty());
  }
}

TEST_CASE("without spheres radiance by exponentiation is the exact sum over texels") {
  const TestScene scene = openScene();
  const auto engine = referenceEngine();
  engine->setShading(tablesFor(scene, 6144, 2));
  const auto expected = engine->shade({}, scene.receivers);
  for (const int order : {4, 5, 6}) {
    engine->setExponentiation(lowOrderTables(scene, order));
    const auto radiance = engine->shadeByExponentiation({}, scene.receivers);
    for (std::size_t i = 0; i < expected.size(); ++i)
      for (int channel = 0; channel < 3; ++channel)
        CHECK(radiance[i][channel] == doctest::Approx(expected[i][channel]).epsilon(2e-6));
  }
}

TEST_CASE("lobes that do not occur are black") {
  TestScene scene = zenithScene();
  const ExponentiationTables tables = lowOrderTables(scene, 4);
  REQUIRE(tables.slotCount() == 2);
  CHECK(tables.lightLobe(0, 0)[0] > 0);
  for (int channel = 0; channel < 3; ++channel)
    for (const float value : tables.lightLobe(1, channel)) CHECK(value == 0);
}

TEST_CASE("one sphere's shadow is that of its projected visibility") {
  TestScene scene = zenithScene();
  for (const int order : {4, 5, 6}) {
    double small = 0, large = 0;
    for (const double polar : {10.0, 40.0, 60.0})
      for (const double radius : {5.0, 12.0, 20.0, 40.0}) {
        scene.spheres = {sphereAt(polar, 30, radius)};
        double& largest = radius <= 20 ? small : large;
        largest = std::max(largest, largestError(scene, order));
      }
    MESSAGE("order ", order, ": error up to 20 degrees ", small, ", up to 40 degrees ", large);
    CHECK(small < 0.004);
    CHECK(large < 0.05);
  }
}

TEST_CASE("the shadow of spheres beside each other is that of their projected visibility") {
  TestScene scene = zenithScene();
  for (int i = 0; i < 5; ++i) scene.spheres.push_back(sphereAt(55, 72 * i, 14));
  scene.spheres.push_back(sphereAt(5, 0, 14));
  for (const int order : {4, 5, 6}) {
    MESSAGE("order ", order, ": error ", largestError(scene, order), " of ",
            shadedByProjection(scene, order).y);
    CHECK(shadedByProjection(scene, order).y < 0.8);
    CHECK(largestError(scene, order) < 0.03);
  }
}

TEST_CASE("spheres whose squares overflow shade like near ones of the same angle") {
  TestScene near = zenithScene(), far = zenithScene();
  near.spheres = {sphereAt(30, 20, 25)};
  far.spheres = {{near.spheres[0].center * 0x1p66f, near.spheres[0].radius * 0x1p66f}};
  const glm::vec3 expected = shadedByReference(near, 5), shaded = shadedByReference(far, 5);
  for (int channel = 0; channel < 3; ++channel)
    CHECK(shaded[channel] == doctest::Approx(expected[channel]).epsilon(1e-5));
  CHECK(shaded.y < 0.9f);
}

TEST_CASE("tables of an order that exponentiation is not offered for are refused") {
  const TestScene scene = zenithScene();
  for (const int order : {1, 7})
    CHECK_THROWS_AS(lowOrderTables(scene, order), std::invalid_argument);
}
