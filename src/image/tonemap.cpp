#include "image/tonemap.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "image/color.h"

namespace haarlight {

float automaticExposure(const Image& image) {
  constexpr double percentile = 0.9, target = 0.65;
  std::vector<double> luminances;
  for (const glm::vec3& pixel : image.pixels)
    if (const double value = luminance(pixel); value > 0 && std::isfinite(value))
      luminances.push_back(value);
  if (luminances.empty()) return 0;
  const auto chosen = luminances.begin() + std::ptrdiff_t(percentile * (luminances.size() - 1));
  std::nth_element(luminances.begin(), chosen, luminances.end());
  return float(std::log2(target / *chosen));
}

Image tonemap(const Image& image, float stops) {
  Image result = image;
  const float factor = std::exp2(stops);
  for (glm::vec3& pixel : result.pixels) pixel = glm::clamp(pixel * factor, 0.0f, 1.0f);
  return result;
}

float srgbFromLinear(float linear) {
  const float value = std::clamp(linear, 0.0f, 1.0f);
  return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}

float linearFromSrgb(float encoded) {
  const float value = std::clamp(encoded, 0.0f, 1.0f);
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t srgbByte(float linear) {
  return std::isnan(linear) ? 0 : std::uint8_t(std::lround(255 * srgbFromLinear(linear)));
}

}  // namespace haarlight
