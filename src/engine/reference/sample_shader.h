#pragma once

#include <cmath>

#include "engine/shading_tables.h"
#include "haar/occlusion_transform.h"

namespace haarlight {

/// One sample's triple product, reading the tables (engine/shading_tables.h).
class SampleShader {
 public:
  SampleShader(const ShadingTables& tables, const OcclusionHaar& occlusion)
      : tables_(tables), occlusion_(occlusion) {}

  /// Σ weight · radiance over the receiver's lobes, the first by multiplication, the others by fma.
  glm::vec4 radiance(const LobeBlend& lobes) const {
    glm::vec4 blend = lobes.weights[0] * radianceOfSlot(tables_.lobeSlots[lobes.lobes[0]]);
    for (int i = 1; i < 3; ++i) {
      const glm::vec4 one = radianceOfSlot(tables_.lobeSlots[lobes.lobes[i]]);
      for (int channel = 0; channel < 3; ++channel)
        blend[channel] = std::fma(lobes.weights[i], one[channel], blend[channel]);
    }
    return blend;
  }

 private:
  glm::vec4 radianceOfSlot(std::uint32_t slot) const {
    glm::uvec4 sum(0);
    std::size_t square = 0;
    for (const SquareDetail detail : {coarseSquares, blockSquares, quarterSquares})
      for (; square < tables_.squareListEnds[detail]; ++square) {
        const glm::uvec4 numbers = numbersOn(detail, square);
        const auto& weights = tables_.weights[slot * tables_.squareCount() + square];
        for (int channel = 0; channel < 3; ++channel)
          for (int k = 0; k < 4; ++k) sum[channel] += weights[channel][k] * numbers[k];
      }
    const glm::ivec4 radiance(tables_.unshadowed[slot] - sum);
    return glm::vec4(radiance) * tables_.scales[slot];
  }

  /// Numbers of blocked texels: a − b + c − d, a + b − c − d, a − b − c + d, a + b + c + d.
  glm::uvec4 numbersOn(SquareDetail detail, std::size_t square) const {
    if (detail == coarseSquares)
      return square < coarseSquareCount ? coarseNumbers(int(square)) : glm::uvec4(0);
    const std::uint32_t place = tables_.squarePlaces[square];
    if (detail == blockSquares)
      return numbersFrom(coarseLevels, blockValues(occlusion_.blocks[place]));
    return numbersFrom(coarseLevels + 1, quarterValues(occlusion_.blocks[place / 4], place % 4));
  }

  glm::uvec4 coarseNumbers(int square) const {
    const int face = square / coarseMeansPerFace, index = square % coarseMeansPerFace;
    const int level = index == 0 ? 0 : index < firstMean(2) ? 1 : 2;
    const float* first =
        &occlusion_
             .coefficients[face * coarseCoefficientsPerFace +
                           coefficientIndex(level, index - firstMean(level), horizontalWavelet)];
    return numbersFrom(level, {first[0], first[1], first[2], occlusion_.means[square]});
  }

  /// Coefficients times 2^{10 − l} and the mean times 2^{10 − 2l} are integers.
  static glm::uvec4 numbersFrom(int level, const SquareValues& values) {
    const float coefficient = float(1 << (2 * haarLevels - level));
    const float mean = float(1 << (2 * (haarLevels - level)));
    return glm::uvec4(glm::ivec4(values.horizontal * coefficient, values.vertical * coefficient,
                                 values.diagonal * coefficient, values.mean * mean));
  }

  const ShadingTables& tables_;
  const OcclusionHaar& occlusion_;
};

}  // namespace haarlight
