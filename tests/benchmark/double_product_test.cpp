#include "benchmark/double_product.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "engine/receivers.h"
#include "engine/shading_tables.h"
#include "verify/cases/random_cases.h"
#include "visibility/exact_visibility.h"

using namespace haarlight;
using namespace haarlight::benchmark;

namespace {

/// Receivers with normals on the grid of lobes and between, below random spheres.
struct Example {
  RadianceCube light = verify::randomLight(5);
  Receivers receivers;
  std::vector<BitCube> cubes;
  std::vector<OcclusionHaar> occlusion;

  Example() {
    verify::PortableRandom random(3);
    const auto coordinate = [&] { return random.uniform(-1, 1); };
    for (int i = 0; i < 12; ++i) {
      const glm::vec3 normal =
          i < 4 ? glm::vec3(0, 1, 0)
                : glm::normalize(glm::vec3(coordinate(), coordinate(), coordinate()));
      receivers.add({coordinate(), coordinate(), coordinate()}, normal);
      std::vector<Sphere> spheres;
      for (int j = 0; j < 3; ++j)
        spheres.push_back({{3 * coordinate(), 3 + coordinate(), 3 * coordinate()}, 0.8f});
      cubes.push_back(exactBitCube(spheres, receivers.positions.back(), normal));
      occlusion.push_back(transformOcclusion(cubes.back()));
    }
  }
};

/// Σ light · blended lobe over the texels that are not blocked: the definition.
glm::dvec3 radianceOf(const Example& example, std::size_t sample) {
  const LobeBlend& blend = example.receivers.lobes[sample];
  glm::dvec3 sum(0);
  for (int i = 0; i < 3; ++i) {
    const auto lobe = cosineLobe(lobeNormal(int(blend.lobes[i])));
    for (int texel = 0; texel < texelCount; ++texel)
      if (!example.cubes[sample].blocked(texel))
        sum += double(blend.weights[i]) * lobe[texel] * glm::dvec3(example.light[texel]);
  }
  return sum / double(texelsPerFace);
}

/// Largest difference, relative to the radiance.
double worstError(const Example& example, const std::vector<glm::vec3>& radiance) {
  double worst = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const glm::dvec3 expected = radianceOf(example, i);
    worst =
        std::max(worst, glm::length(glm::dvec3(radiance[i]) - expected) / glm::length(expected));
  }
  return worst;
}

// Sums of a few thousand single-precision terms of either sign.
constexpr double rounding = 2e-4;

}  // namespace

TEST_CASE("with all texels the sum over blocked ones is the definition") {
  const Example example;
  const TexelProduct product(example.light, example.receivers.lobes);
  CHECK(worstError(example, product.radiance(example.cubes, example.receivers.lobes)) < rounding);
}

TEST_CASE("with all terms the dot product is the definition") {
  const Example example;
  const HaarProduct product(example.light, example.receivers.lobes, maximumTerms);
  CHECK(worstError(example, product.radiance(example.occlusion, example.receivers.lobes)) <
        rounding);
}

TEST_CASE("fewer terms leave a larger error, and none are needed where nothing blocks") {
  Example example;
  const auto error = [&](int terms) {
    const HaarProduct product(example.light, example.receivers.lobes, terms);
    return worstError(example, product.radiance(example.occlusion, example.receivers.lobes));
  };
  CHECK(error(0) > error(1000));
  CHECK(error(1000) > error(maximumTerms));
  for (BitCube& cube : example.cubes) cube = {};
  for (OcclusionHaar& occlusion : example.occlusion) occlusion = transformOcclusion(BitCube{});
  CHECK(error(0) < rounding);
}
