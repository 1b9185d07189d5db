#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>

#include "engine/shading_tables.h"
#include "haar/occlusion_transform.h"

namespace haarlight {

/// Partial sums of the canonical order, one per colour channel (engine/shading_tables.h).
class CanonicalSum {
 public:
  /// Adds term k of a list: coefficient (RGB) times value.
  void add(std::size_t k, const glm::vec4& coefficient, float value) {
    glm::vec3& partial = partials_[k % partialSums];
    for (int channel = 0; channel < 3; ++channel)
      partial[channel] = std::fma(coefficient[channel], value, partial[channel]);
  }

  glm::vec3 total() const { return combineAsTree(partials_, std::plus<>()); }

 private:
  std::array<glm::vec3, partialSums> partials_{};
};

/// Σ weight · value over the receiver's lobes, the first by multiplication, the others by fma.
template <typename ValueOfLobe>
glm::vec4 blendLobeValues(const LobeBlend& lobes, const ValueOfLobe& valueOfLobe) {
  glm::vec4 sum = lobes.weights[0] * valueOfLobe(lobes.lobes[0]);
  for (int i = 1; i < 3; ++i) {
    const glm::vec4 value = valueOfLobe(lobes.lobes[i]);
    for (int j = 0; j < 4; ++j) sum[j] = std::fma(lobes.weights[i], value[j], sum[j]);
  }
  return sum;
}

inline float dotSquareValues(const glm::vec4& weight, const SquareValues& values) {
  float sum = weight.x * values.horizontal;
  sum = std::fma(weight.y, values.vertical, sum);
  sum = std::fma(weight.z, values.diagonal, sum);
  return std::fma(weight.w, values.mean, sum);
}

/// One sample's triple product, reading the tables. `Sum` decides the order of summation; another
/// one than the canonical order gives other last bits.
template <typename Sum = CanonicalSum>
class SampleShader {
 public:
  SampleShader(const ShadingTables& tables, const OcclusionHaar& occlusion, const LobeBlend& lobes)
      : tables_(tables), occlusion_(occlusion), slots_(lobes) {
    for (std::uint32_t& lobe : slots_.lobes) lobe = tables.lobeSlots[lobe];
  }

  glm::vec4 radiance() {
    addLightTerms();
    for (int i = 0; i < 3; ++i) addLobeTerms(slots_.lobes[i], slots_.weights[i]);
    const glm::vec4 unshadowed =
        blendLobeValues(slots_, [&](std::uint32_t slot) { return tables_.unshadowed[slot]; });
    return {glm::vec3(unshadowed) - sum_.total(), 0};
  }

 private:
  void addLightTerms() {
    std::size_t term = 0;
    for (const TermDetail detail : {coarseTerm, blockTerm, quarterTerm})
      for (std::size_t k = 0; term < tables_.lightListEnds[detail]; ++term, ++k) {
        const glm::vec4 weight = blendLobeValues(slots_, [&](std::uint32_t slot) {
          return tables_.lightWeights[slot * tables_.lightTermCount() + term];
        });
        sum_.add(k, tables_.lightCoefficients[term],
                 dotSquareValues(weight, squareValues(detail, tables_.lightPlaces[term])));
      }
  }

  void addLobeTerms(std::uint32_t slot, float weight) {
    for (const TermDetail detail : {coarseTerm, blockTerm, quarterTerm}) {
      const std::uint32_t first = tables_.lobeListStarts[slot * termDetails + detail];
      const std::uint32_t last = tables_.lobeListStarts[slot * termDetails + detail + 1];
      for (std::uint32_t term = first; term < last; ++term) {
        const std::uint32_t place = tables_.lobePlaces[term];
        sum_.add(term - first, tables_.lightMeans[place >> 16],
                 (weight * tables_.lobeValues[term]) * coefficient(detail, place & 0xffff));
      }
    }
  }

  /// Occlusion on the square of a light term. At level I blocks are uniform: the occlusion of a
  /// block and of its quarters is the block's mean.
  SquareValues squareValues(TermDetail detail, std::uint32_t place) const {
    if (detail == coarseTerm) {
      const float* first = &occlusion_.coefficients[place & 0xffff];
      return {first[0], first[1], first[2], occlusion_.means[place >> 16]};
    }
    const std::uint16_t block = occlusion_.blocks[detail == blockTerm ? place : place / 4];
    if (tables_.settings.levels == 1) return {0, 0, 0, blockValues(block).mean};
    return detail == blockTerm ? blockValues(block) : quarterValues(block, int(place % 4));
  }

  /// Occlusion coefficient of a lobe term.
  float coefficient(TermDetail detail, std::uint32_t place) const {
    if (detail == coarseTerm) return occlusion_.coefficients[place];
    if (tables_.settings.levels == 1) return 0;
    const std::size_t block = occlusion_.blocks[place / blockTableStride];
    return blockTable()[block * blockTableStride + place % blockTableStride];
  }

  const ShadingTables& tables_;
  const OcclusionHaar& occlusion_;
  /// The receiver's blend, by slots.
  LobeBlend slots_;
  Sum sum_;
};

}  // namespace haarlight
