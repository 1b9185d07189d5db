#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "base/canonical_order.h"
#include "engine/exponentiation_tables.h"
#include "material/cosine_lobe.h"
#include "shexp/exponentiation.h"
#include "shexp/float_functions.h"

namespace haarlight {

/// Radiance of samples by exponentiation, reading the tables (engine/exponentiation_tables.h).
class ExponentiationShader {
 public:
  explicit ExponentiationShader(const ExponentiationTables& tables) : tables_(tables) {}

  glm::vec4 radiance(std::span<const Sphere> spheres, const glm::vec3& position,
                     const glm::vec3& normal, const LobeBlend& lobes) const {
    const ShexpVector visibility = shexpVisibility(tables_.visibility, spheres, position, normal);
    glm::vec4 radiance(0);
    for (int channel = 0; channel < 3; ++channel) {
      radiance[channel] = positivePart(channelSum(visibility, lobes, channel));
    }
    return radiance;
  }

 private:
  float channelSum(const ShexpVector& visibility, const LobeBlend& lobes, int channel) const {
    std::array<std::span<const float>, 3> rows;
    for (int i = 0; i < 3; ++i)
      rows[i] = tables_.lightLobe(tables_.lobeSlots[lobes.lobes[i]], channel);
    std::array<float, partialSums> partials{};
    for (std::size_t k = 0; k < ExponentiationTables::rowSize; ++k) {
      float lightLobe = lobes.weights[0] * rows[0][k];
      for (int i = 1; i < 3; ++i) lightLobe = std::fma(lobes.weights[i], rows[i][k], lightLobe);
      float& partial = partials[k % partialSums];
      partial = std::fma(k < visibility.size() ? visibility[k] : 0.0f, lightLobe, partial);
    }
    return combineAsTree(partials, std::plus<>());
  }

  const ExponentiationTables& tables_;
};

}  // namespace haarlight
