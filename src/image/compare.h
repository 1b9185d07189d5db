#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "image/image.h"

namespace haarlight {

/// How far an image is from its reference, over the pixels compared and their three channels.
struct ImageError {
  double rootMeanSquare = 0;  ///< of the differences
  double referenceMean = 0;   ///< mean value of the reference
  /// rootMeanSquare / referenceMean; 0 when both are 0, infinite when only the mean is.
  double relativeRootMeanSquare = 0;
  double maximum = 0;         ///< largest absolute difference of a channel
  glm::ivec2 maximumPixel{};  ///< its column and row (the first such pixel)
  std::size_t pixelCount = 0;
};

/// Compares pixel by pixel; where a mask (one value per pixel) is given, only where it is not 0.
/// Throws InputError when the sizes differ or the mask selects no pixel.
ImageError compareImages(const Image& image, const Image& reference,
                         std::span<const std::uint8_t> mask = {});

/// Colour picture of |image − reference|: the largest channel's difference times `scale`, from 0
/// (black) over violet and orange to 1 and above (pale yellow) in matplotlib's perceptually even
/// map "inferno". Linear, ready for writePng. Throws InputError when the sizes differ.
Image differenceImage(const Image& image, const Image& reference, float scale = 1);

/// Linear colour of matplotlib's map "inferno" at a value clamped to [0, 1].
glm::vec3 infernoColor(float value);

}  // namespace haarlight
