#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/error.h"
#include "haar/triple_product.h"
#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// The blend of lobes as the engines tabulate it (float32 coefficients), as an image in double.
std::vector<double> lobeImage(const LobeBlend& blend) {
  std::vector<double> image(texelCount);
  for (int i = 0; i < 3; ++i) {
    if (blend.weights[i] == 0) continue;
    const auto lobe = cosineLobe(lobeNormal(int(blend.lobes[i])));
    for (int texel = 0; texel < texelCount; ++texel)
      image[texel] += double(blend.weights[i]) * lobe[texel];
  }
  return image;
}

struct TexelSums {
  glm::dvec3 radiance{0};
  glm::dvec3 unshadowed{0};
};

/// Σ L V ρ̃ over the 6144 texels, in double.
TexelSums sumOverTexels(const RadianceCube& light, const BitCube& blocked,
                        const std::vector<double>& lobe) {
  TexelSums sums;
  for (int texel = 0; texel < texelCount; ++texel) {
    const glm::dvec3 term = glm::dvec3(light[texel]) * lobe[texel] / double(texelsPerFace);
    sums.unshadowed += term;
    if (!blocked.blocked(texel)) sums.radiance += term;
  }
  return sums;
}

RadianceCube constantLight() {
  RadianceCube light;
  for (auto& texel : light.texels) texel = glm::vec3(1);
  return light;
}

/// Receiver at the origin with the normal +Y under a constant light of 1.
float radianceUnder(const Sphere* sphere, VisibilityKind visibility) {
  TestScene scene;
  scene.light = constantLight();
  scene.receivers.add({0, 0, 0}, {0, 1, 0});
  if (sphere) scene.spheres.push_back(*sphere);
  const auto engine = referenceEngine(visibility);
  engine->setShading(tablesFor(scene, maximumTerms, 2));
  return engine->shade(scene.spheres, scene.receivers)[0].x;
}

}  // namespace

TEST_CASE("all terms: radiance equals the sum over texels on 1,000 random samples") {
  const auto engine = referenceEngine();
  for (unsigned seed = 0; seed < 125; ++seed) {
    const TestScene scene = randomScene(5000 + seed, 8);
    engine->setShading(tablesFor(scene, maximumTerms, 2));
    const auto radiance = engine->shade(scene.spheres, scene.receivers);
    const auto cubes = engine->mergeBitCubes(scene.spheres, scene.receivers);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const auto sums = sumOverTexels(scene.light, cubes[i], lobeImage(scene.receivers.lobes[i]));
      // Relative to the unshadowed value: a float32 sum cannot do better where all but a part in
      // 10⁷ of the light is blocked.
      for (int channel = 0; channel < 3; ++channel)
        REQUIRE(std::abs(radiance[i][channel] - sums.radiance[channel]) <=
                1e-6 * sums.unshadowed[channel]);
    }
  }
}

TEST_CASE("all terms: light less occlusion is the triple product of light, visibility and lobe") {
  const TestScene scene = randomScene(11, 2);
  const auto engine = referenceEngine();
  engine->setShading(tablesFor(scene, maximumTerms, 2));
  const auto radiance = engine->shade(scene.spheres, scene.receivers);
  const auto cubes = engine->mergeBitCubes(scene.spheres, scene.receivers);
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    std::vector<double> light(texelCount), visibility(texelCount);
    for (int texel = 0; texel < texelCount; ++texel) {
      light[texel] = scene.light[texel].g;
      visibility[texel] = !cubes[i].blocked(texel);
    }
    const auto lobe = lobeImage(scene.receivers.lobes[i]);
    const double expected = tripleProduct(haarForwardCube<double, double>(light),
                                          haarForwardCube<double, double>(visibility),
                                          haarForwardCube<double, double>(lobe));
    CHECK(radiance[i].g == doctest::Approx(expected).epsilon(1e-5));
  }
}

TEST_CASE("white furnace: constant light 1, albedo 1, no blocker gives 1") {
  CHECK(radianceUnder(nullptr, VisibilityKind::exact) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("white furnace: any number of terms, since the unshadowed part is exact") {
  for (const int terms : {0, 50, 200}) {
    TestScene scene;
    scene.light = constantLight();
    scene.receivers.add({1, 2, 3}, glm::normalize(glm::vec3(1, 2, -1)));
    const auto engine = referenceEngine();
    engine->setShading(tablesFor(scene, terms, 1));
    // The blended lobe's excess is at most 0.4 % (src/material/cosine_lobe.h).
    CHECK(engine->shade({}, scene.receivers)[0].x == doctest::Approx(1).epsilon(0.004));
  }
}

TEST_CASE("a sphere straight above a plane sample leaves 1 − sin²α") {
  // The mask counts whole texels: at most half a texel, 1/32 of the tangent plane, along the rim of
  // cosine-weighted length 2 r cos α (per π). The table besides rounds r to
  // the middle of a bin that is at most 2 · 0.0235 wide, so Δ(sin²α) ≤ 2 r · 0.0235, and the
  // direction to a texel's centre, half a diagonal away.
  for (const float r : {0.1f, 0.2f, 0.3f, 0.5f, 0.7f, 0.8f, 0.95f}) {
    CAPTURE(r);
    const Sphere sphere{{0, 10, 0}, 10 * r};
    const double texels = 2 * r * std::sqrt(1 - r * r) / 32, bin = 2 * r * 0.0235;
    const double expected = 1 - double(r) * r;
    CHECK(std::abs(radianceUnder(&sphere, VisibilityKind::exact) - expected) <= texels);
    CHECK(std::abs(radianceUnder(&sphere, VisibilityKind::table) - expected) <= texels + bin);
  }
}

TEST_CASE("the error falls as terms are added") {
  const TestScene scene = randomScene(23, 40);
  const auto engine = referenceEngine();
  const auto errorWith = [&](int terms) {
    engine->setShading(tablesFor(scene, terms, 2));
    const auto radiance = engine->shade(scene.spheres, scene.receivers);
    engine->setShading(tablesFor(scene, maximumTerms, 2));
    const auto complete = engine->shade(scene.spheres, scene.receivers);
    double sum = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const glm::dvec3 difference(radiance[i] - complete[i]);
      sum += glm::dot(difference, difference);
    }
    return std::sqrt(sum);
  };
  CHECK(errorWith(0) > errorWith(100));
  CHECK(errorWith(100) > errorWith(400));
  CHECK(errorWith(400) > errorWith(2000));
  CHECK(errorWith(maximumTerms) == 0);
}

TEST_CASE("terms and levels out of range are refused") {
  const RadianceCube light;
  const std::vector<double> importance(lobeCount, 0);
  CHECK_THROWS_AS(buildShadingTables(light, {.terms = -1}, importance), InputError);
  CHECK_THROWS_AS(buildShadingTables(light, {.terms = 6145}, importance), InputError);
  CHECK_THROWS_AS(buildShadingTables(light, {.terms = 200, .levels = 3}, importance), InputError);
}
