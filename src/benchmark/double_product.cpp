#include "benchmark/double_product.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/parallel.h"
#include "haar/transform.h"

namespace haarlight::benchmark {

namespace {

constexpr std::size_t samplesPerTask = 256;

/// Light times lobe at every texel, scaled so that radiance is the sum of its means over the faces.
std::vector<glm::dvec3> productWithLobe(const RadianceCube& light, int lobe) {
  const std::vector<double> values = cosineLobe(lobeNormal(lobe));
  std::vector<glm::dvec3> product(texelCount);
  for (int texel = 0; texel < texelCount; ++texel)
    product[texel] = values[texel] * glm::dvec3(light[texel]);
  return product;
}

/// Calls make(lobe) once for each lobe that has a weight in `blends`.
template <typename Make>
void forEachLobe(std::span<const LobeBlend> blends, const Make& make) {
  std::vector<char> occurs(lobeCount);
  for (const LobeBlend& blend : blends)
    for (int i = 0; i < 3; ++i)
      if (blend.weights[i] != 0) occurs[blend.lobes[i]] = 1;
  for (int lobe = 0; lobe < lobeCount; ++lobe)
    if (occurs[lobe]) make(lobe);
}

/// Σ weight · value(lobe) of each sample's blend.
template <typename Value>
std::vector<glm::vec3> blended(std::span<const LobeBlend> blends, const Value& value) {
  std::vector<glm::vec3> radiance(blends.size());
  parallelFor(blends.size(), samplesPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t sample = begin; sample < end; ++sample) {
      glm::vec4 sum(0);
      for (int i = 0; i < 3; ++i)
        if (blends[sample].weights[i] != 0)
          sum += blends[sample].weights[i] * value(sample, blends[sample].lobes[i]);
      radiance[sample] = glm::vec3(sum);
    }
  });
  return radiance;
}

/// Σ of `count` vectors in four sums, so that additions need not wait for one another.
template <typename Addend>
glm::vec4 sumOf(std::size_t count, const Addend& addend) {
  std::array<glm::vec4, 4> sums{};
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    for (std::size_t j = 0; j < 4; ++j) sums[j] += addend(i + j);
  for (; i < count; ++i) sums[0] += addend(i);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

glm::vec4 blockedSum(const std::vector<glm::vec4>& texels, const BitCube& cube) {
  std::array<glm::vec4, 2> sums{};
  for (int row = 0; row < bitCubeRows; ++row)
    for (std::uint32_t bits = cube.rows[row]; bits; bits &= bits - 1)
      sums[row & 1] += texels[row * faceSize + std::countr_zero(bits)];
  return sums[0] + sums[1];
}

/// The place of a wavelet of levels 3 and 4 in the table of blocks.
std::uint32_t blockPlace(int face, const Wavelet& wavelet) {
  const int side = squaresPerSide(wavelet.level);
  const int row = wavelet.square / side, column = wavelet.square % side;
  const bool quarter = wavelet.level == coarseLevels + 1;
  const int block = quarter ? row / 2 * blocksPerSide + column / 2 : wavelet.square;
  const int slot = quarter ? 4 + 3 * (row % 2 * 2 + column % 2) + wavelet.type : 1 + wavelet.type;
  return std::uint32_t((face * blocksPerFace + block) * blockTableStride + slot);
}

}  // namespace

TexelProduct::TexelProduct(const RadianceCube& light, std::span<const LobeBlend> lobes)
    : lobes_(lobeCount) {
  forEachLobe(lobes, [&](int lobe) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& value : productWithLobe(light, lobe)) {
      lobes_[lobe].texels.emplace_back(glm::vec3(value / double(texelsPerFace)), 0);
      sum += value / double(texelsPerFace);
    }
    lobes_[lobe].unshadowed = glm::vec4(glm::vec3(sum), 0);
  });
}

std::vector<glm::vec3> TexelProduct::radiance(std::span<const BitCube> cubes,
                                              std::span<const LobeBlend> lobes) const {
  return blended(lobes, [&](std::size_t sample, std::uint32_t lobe) {
    return lobes_[lobe].unshadowed - blockedSum(lobes_[lobe].texels, cubes[sample]);
  });
}

HaarProduct::HaarProduct(const RadianceCube& light, std::span<const LobeBlend> lobes, int terms)
    : lobes_(lobeCount) {
  forEachLobe(lobes, [&](int lobe) { lobes_[lobe] = cut(productWithLobe(light, lobe), terms); });
}

HaarProduct::Lobe HaarProduct::cut(const std::vector<glm::dvec3>& product, int terms) {
  const auto haar = haarForwardCube<glm::dvec3, double>(std::span<const glm::dvec3>(product));
  std::vector<std::pair<double, int>> ranked;
  for (int index = 0; index < texelCount; ++index) {
    if (index % coefficientsPerFace == 0) continue;
    const glm::dvec3& c =
        haar[index / coefficientsPerFace].coefficients[index % coefficientsPerFace];
    const int level = waveletAt(index % coefficientsPerFace).level;
    const double magnitude = std::abs(c.r) + std::abs(c.g) + std::abs(c.b);
    if (magnitude > 0) ranked.emplace_back(-magnitude * std::exp2(-1.5 * level), index);
  }
  std::ranges::sort(ranked);
  ranked.resize(std::min(ranked.size(), std::size_t(terms)));
  for (int face = 0; face < faceCount; ++face) ranked.emplace_back(0, face * coefficientsPerFace);
  std::ranges::sort(ranked, {}, &std::pair<double, int>::second);  // places in ascending order
  Lobe lobe;
  for (const auto& [ignored, index] : ranked) {
    const int face = index / coefficientsPerFace, k = index % coefficientsPerFace;
    const glm::vec4 coefficient(glm::vec3(haar[face].coefficients[k]), 0);
    if (k == 0) lobe.unshadowed += coefficient;
    if (k < coarseCoefficientsPerFace)
      lobe.coarse.push_back({coefficient, std::uint32_t(face * coarseCoefficientsPerFace + k)});
    else
      lobe.fine.push_back({coefficient, blockPlace(face, waveletAt(k))});
  }
  return lobe;
}

std::vector<glm::vec3> HaarProduct::radiance(std::span<const OcclusionHaar> occlusion,
                                             std::span<const LobeBlend> lobes) const {
  const float* table = blockTable().data();
  return blended(lobes, [&](std::size_t sample, std::uint32_t index) {
    const Lobe& lobe = lobes_[index];
    const OcclusionHaar& blocked = occlusion[sample];
    const glm::vec4 coarse = sumOf(lobe.coarse.size(), [&](std::size_t i) {
      return lobe.coarse[i].coefficient * blocked.coefficients[lobe.coarse[i].place];
    });
    const glm::vec4 fine = sumOf(lobe.fine.size(), [&](std::size_t i) {
      const auto& [coefficient, place] = lobe.fine[i];
      const std::size_t bits = blocked.blocks[place / blockTableStride];
      return coefficient * table[bits * blockTableStride + place % blockTableStride];
    });
    return lobe.unshadowed - (coarse + fine);
  });
}

}  // namespace haarlight::benchmark
