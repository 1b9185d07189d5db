#include "image/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "base/error.h"
#include "image/tonemap.h"

namespace haarlight {

namespace {

std::string sizeName(const Image& image) {
  return std::to_string(image.width) + "×" + std::to_string(image.height);
}

void checkEqualSize(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height)
    throw InputError("cannot compare images of different size: " + sizeName(image) + " and " +
                     sizeName(reference) + " pixels");
}

float largestChannel(const glm::vec3& v) {
  return std::max({v.r, v.g, v.b});
}

double ratio(double numerator, double denominator) {
  if (denominator != 0) return numerator / denominator;
  return numerator == 0 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace

ImageError compareImages(const Image& image, const Image& reference,
                         std::span<const std::uint8_t> mask) {
  checkEqualSize(image, reference);
  if (!mask.empty() && mask.size() != image.pixels.size())
    throw std::invalid_argument("compareImages needs one mask value per pixel");
  ImageError error;
  double squares = 0, referenceSum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    ++error.pixelCount;
    for (int c = 0; c < 3; ++c) {
      const double difference = double(image.pixels[i][c]) - double(reference.pixels[i][c]);
      squares += difference * difference;
      referenceSum += reference.pixels[i][c];
      if (std::abs(difference) <= error.maximum) continue;
      error.maximum = std::abs(difference);
      error.maximumPixel = glm::ivec2(i % image.width, i / image.width);
    }
  }
  if (error.pixelCount == 0) throw InputError("cannot compare images: no pixel is selected");
  error.rootMeanSquare = std::sqrt(squares / (3.0 * error.pixelCount));
  error.referenceMean = referenceSum / (3.0 * error.pixelCount);
  error.relativeRootMeanSquare = ratio(error.rootMeanSquare, error.referenceMean);
  return error;
}

Image differenceImage(const Image& image, const Image& reference, float scale) {
  checkEqualSize(image, reference);
  Image result(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    result.pixels[i] =
        infernoColor(scale * largestChannel(glm::abs(image.pixels[i] - reference.pixels[i])));
  return result;
}

glm::vec3 infernoColor(float value) {
  // Polynomial fit in sRGB by M. Zucker, shadertoy.com/view/WlfXRN (public domain).
  static constexpr std::array<glm::vec3, 7> coefficients{
      glm::vec3{0.0002189403691192265f, 0.001651004631001012f, -0.01948089843709184f},
      glm::vec3{0.1065134194856116f, 0.5639564367884091f, 3.932712388889277f},
      glm::vec3{11.60249308247187f, -3.972853965665698f, -15.9423941062914f},
      glm::vec3{-41.70399613139459f, 17.43639888205313f, 44.35414519872813f},
      glm::vec3{77.162935699427f, -33.40235894210092f, -81.80730925738993f},
      glm::vec3{-71.31942824499214f, 32.62606426397723f, 73.20951985803202f},
      glm::vec3{25.13112622477341f, -12.24266895238567f, -23.07032500287172f}};
  const float x = std::clamp(value, 0.0f, 1.0f);
  glm::vec3 color(0.0f);
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) color = color * x + *c;
  return {linearFromSrgb(color.r), linearFromSrgb(color.g), linearFromSrgb(color.b)};
}

}  // namespace haarlight
