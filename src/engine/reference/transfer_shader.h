#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "base/canonical_order.h"
#include "engine/transfer_tables.h"
#include "shexp/float_functions.h"

namespace haarlight {

/// Radiance of receivers by precomputed transfer (engine/transfer_tables.h, with the formulas).
class TransferShader {
 public:
  TransferShader(const TransferRows& rows, const TransferLights& lights)
      : rows_(rows), lights_(lights) {}

  glm::vec4 radiance(const RowBlend& blend, std::span<const float> lightWeights) const {
    glm::vec4 radiance(0);
    for (int channel = 0; channel < 3; ++channel) {
      radiance[channel] = positivePart(channelSum(blend, lightWeights, channel));
    }
    return radiance;
  }

 private:
  float channelSum(const RowBlend& blend, std::span<const float> lightWeights, int channel) const {
    std::array<float, partialSums> partials{};
    for (std::size_t k = 0; k < rows_.coefficients(); ++k) {
      float& partial = partials[k % partialSums];
      partial = std::fma(transfer(blend, channel, k), light(lightWeights, channel, k), partial);
    }
    return combineAsTree(partials, std::plus<>());
  }

  float transfer(const RowBlend& blend, int channel, std::size_t k) const {
    float transfer = blend.weights[0] * rows_.row(blend.rows[0], channel)[k];
    for (int i = 1; i < 3; ++i)
      transfer = std::fma(blend.weights[i], rows_.row(blend.rows[i], channel)[k], transfer);
    return transfer;
  }

  float light(std::span<const float> weights, int channel, std::size_t k) const {
    float light = weights[0] * lights_.light(0, channel)[k];
    for (std::size_t i = 1; i < weights.size(); ++i)
      light = std::fma(weights[i], lights_.light(i, channel)[k], light);
    return light;
  }

  const TransferRows& rows_;
  const TransferLights& lights_;
};

}  // namespace haarlight
