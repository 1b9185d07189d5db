#pragma once

#include <cstdint>

#include "image/image.h"

namespace haarlight {

/// The exposure, in stops, that brings the 90th percentile of the luminance of all pixels that are
/// not black to 0.65, so that most of the picture is neither clipped nor dark; 0 for a black image.
float automaticExposure(const Image& image);

/// The image times 2^stops, clamped to [0, 1]; still linear. No curve: pictures of different
/// methods stay comparable.
Image tonemap(const Image& image, float stops);

/// sRGB transfer function (IEC 61966-2-1) of a linear value clamped to [0, 1], and its inverse.
float srgbFromLinear(float linear);
float linearFromSrgb(float encoded);

/// srgbFromLinear, rounded to 8 bits; NaN gives 0.
std::uint8_t srgbByte(float linear);

}  // namespace haarlight
