#include "engine/square_weights.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "cube/bit_cube.h"
#include "material/cosine_lobe.h"
#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// The weights of one lobe under the light of a random scene.
struct Example {
  LightHaar light;
  HaarCube<float> lobe;
  SquareList squares;
  ExactSquareWeights exact;
  glm::dvec3 unshadowed{0};
  RoundedLobe rounded;

  Example(unsigned seed, const ShadingSettings& settings)
      : Example(lightOf(seed), seed, settings) {}

 private:
  Example(LightHaar lightHaar, unsigned seed, const ShadingSettings& settings)
      : light(std::move(lightHaar)),
        lobe(lobeHaar(int(seed * 7919 % lobeCount))),
        squares(termsOf(settings), settings),
        exact(gatherBySquares(squares, settings, light, termsOf(settings), lobe)) {
    for (int face = 0; face < faceCount; ++face)
      for (int i = 0; i < coefficientsPerFace; ++i)
        unshadowed += light[face].coefficients[i] * double(lobe[face].coefficients[i]);
    rounded = roundWeights(squares, exact, unshadowed);
  }

  static LightHaar lightOf(unsigned seed) {
    const RadianceCube light = randomScene(seed, 1).light;
    std::vector<glm::dvec3> texels(light.texels.begin(), light.texels.end());
    return haarForwardCube<glm::dvec3, double>(texels);
  }
  std::vector<LightTerm> termsOf(const ShadingSettings& settings) const {
    MeanLobe mean;
    mean.add(lobe, 1);
    return selectLightTerms(light, settings, mean);
  }
};

/// Caps of random sizes, so that large squares are blocked too.
std::vector<bool> randomOcclusion(std::mt19937& random) {
  std::vector<bool> blocked(texelCount);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int cap = 0; cap < 5; ++cap) {
    const glm::dvec3 axis(uniform(random), uniform(random), uniform(random));
    const double bound = uniform(random);
    for (int texel = 0; texel < texelCount; ++texel)
      if (glm::dot(texelDirection(texel), axis) > bound) blocked[texel] = true;
  }
  return blocked;
}

/// Blocked texels in the rows and columns of a face from `row` and `column` on.
int blockedIn(const std::vector<bool>& blocked, int face, int row, int column, int size) {
  int number = 0;
  for (int y = row; y < row + size; ++y)
    for (int x = column; x < column + size; ++x)
      number += blocked[(face * faceSize + y) * faceSize + x];
  return number;
}

/// Σ weights · numbers over the squares, with numbers counted texel by texel.
template <typename Vec3, typename Vec4>
Vec3 sumOverSquares(const SquareList& squares, const std::vector<ChannelWeights<Vec4>>& weights,
                    const std::vector<bool>& blocked) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const auto [face, level, square] = squares[i];
    if (level < 0) continue;
    const int side = 1 << level, size = faceSize / side, part = size / 2;
    const int row = square / side * size, column = square % side * size;
    const int a = blockedIn(blocked, face, row, column, part),
              b = blockedIn(blocked, face, row, column + part, part),
              c = blockedIn(blocked, face, row + part, column, part),
              d = blockedIn(blocked, face, row + part, column + part, part);
    using Number = typename Vec3::value_type;
    for (int channel = 0; channel < 3; ++channel) {
      const Vec4& weight = weights[i][channel];
      sum[channel] += weight.x * Number(a - b + c - d) + weight.y * Number(a + b - c - d) +
                      weight.z * Number(a - b - c + d) + weight.w * Number(a + b + c + d);
    }
  }
  return sum;
}

template <typename Vec3>
Vec3 sumOverTexels(const std::vector<Vec3>& weights, const std::vector<bool>& blocked) {
  Vec3 sum(0);
  for (int texel = 0; texel < texelCount; ++texel)
    if (blocked[texel]) sum += weights[texel];
  return sum;
}

}  // namespace

TEST_CASE("square weights: the sum over squares is that over texels, bit by bit") {
  std::mt19937 random(1);
  for (const int terms : {0, 50, 200, 6144})
    for (const int levels : {1, 2}) {
      CAPTURE(terms);
      CAPTURE(levels);
      const Example example(unsigned(terms + levels), {terms, levels});
      const auto texels = spreadOverTexels<glm::uvec3>(
          example.squares, std::span<const ChannelWeights<glm::uvec4>>(example.rounded.weights));
      for (int i = 0; i < 10; ++i) {
        const auto blocked = randomOcclusion(random);
        REQUIRE(sumOverTexels(texels, blocked) ==
                sumOverSquares<glm::uvec3>(example.squares, example.rounded.weights, blocked));
      }
    }
}

TEST_CASE("square weights: rounding moves a texel's weight by at most 2 units") {
  // A unit is 2^-31 … 2^-29 of the largest sum. What rounding takes is handed on to the squares in
  // the quarters; only the last square of a chain keeps it, four times half a unit.
  for (const int terms : {50, 200, 6144}) {
    const Example example(unsigned(terms), {terms, 2});
    const auto exact = spreadOverTexels<glm::dvec3>(
        example.squares, std::span<const ChannelWeights<glm::dvec4>>(example.exact));
    const auto rounded = spreadOverTexels<glm::uvec3>(
        example.squares, std::span<const ChannelWeights<glm::uvec4>>(example.rounded.weights));
    glm::dvec3 low(example.unshadowed), high(example.unshadowed);
    for (int texel = 0; texel < texelCount; ++texel)
      for (int channel = 0; channel < 3; ++channel) {
        const double unit = example.rounded.scale[channel];
        const double value = double(std::int32_t(rounded[texel][channel])) * unit;
        REQUIRE(std::abs(value - exact[texel][channel]) <= 2.0001 * unit);
        (value > 0 ? low : high)[channel] -= value;
      }
    for (int channel = 0; channel < 3; ++channel) {
      const double largest = std::max(std::abs(low[channel]), std::abs(high[channel]));
      CHECK(largest / example.rounded.scale[channel] < 0x1p31);
      CHECK(largest / example.rounded.scale[channel] > 0x1p29);
    }
  }
}

TEST_CASE("square weights: with all terms a texel weighs its light times the lobe") {
  const Example example(3, {maximumTerms, 2});
  const auto exact = spreadOverTexels<glm::dvec3>(
      example.squares, std::span<const ChannelWeights<glm::dvec4>>(example.exact));
  const RadianceCube light = randomScene(3, 1).light;
  std::vector<glm::dvec3> expected;
  glm::dvec3 largest(0);
  for (int face = 0; face < faceCount; ++face)
    for (const float lobe : haarInverse<float, float>(example.lobe[face].coefficients)) {
      const glm::dvec3 radiance(light[int(expected.size())]);
      expected.push_back(radiance * double(lobe) / double(texelsPerFace));
      largest = glm::max(largest, expected.back());
    }
  // Lobes are tabulated in float32: 2^-24 of the largest, level after level.
  for (int texel = 0; texel < texelCount; ++texel)
    for (int channel = 0; channel < 3; ++channel)
      REQUIRE(std::abs(exact[texel][channel] - expected[texel][channel]) <=
              1e-6 * largest[channel]);
}

TEST_CASE("square weights: at level I the texels of a block weigh the same") {
  const Example example(5, {200, 1});
  CHECK(example.squares.ends()[quarterSquares] == example.squares.ends()[blockSquares]);
  const auto texels = spreadOverTexels<glm::uvec3>(
      example.squares, std::span<const ChannelWeights<glm::uvec4>>(example.rounded.weights));
  for (int texel = 0; texel < texelCount; ++texel) {
    const int row = texel / faceSize, column = texel % faceSize;
    REQUIRE(texels[texel] == texels[row / 4 * 4 * faceSize + column / 4 * 4]);
  }
}

TEST_CASE("square weights: a light of zero has weights of zero") {
  const SquareList squares({}, {0, 2});
  const ExactSquareWeights none(squares.size(), {glm::dvec4(0), glm::dvec4(0), glm::dvec4(0)});
  const RoundedLobe rounded = roundWeights(squares, none, glm::dvec3(0));
  CHECK(rounded.unshadowed == glm::uvec4(0));
  CHECK(std::ranges::all_of(rounded.weights, [](const auto& weights) {
    return weights[0] == glm::uvec4(0) && weights[1] == glm::uvec4(0) &&
           weights[2] == glm::uvec4(0);
  }));
}
