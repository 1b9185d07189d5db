#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "cube/bit_cube.h"
#include "verify/report/report.h"

namespace haarlight::verify {

/// The six faces +X −X +Y −Y +Z −Z beside each other, blocked texels dark and open ones light.
/// Difference: equal texels faint, wrong ones red.
DifferencePicture bitCubePicture(const std::string& title, const BitCube& expected,
                                 const BitCube& actual);

/// Linear radiance (RGB, w unused), row by row; both parts with the exposure that puts the largest
/// finite expected value at white. Difference: equal pixels grey, others from blue (1 ULP) by
/// logarithm to red (2³¹ ULP). Throws std::invalid_argument when a size does not fit.
DifferencePicture framePicture(const std::string& title, int width, int height,
                               std::span<const glm::vec4> expected,
                               std::span<const glm::vec4> actual);

/// Steps between two float32 values, −0 and +0 being one step apart; 0 only for equal bits. A NaN
/// is 2³² − 1 steps from everything else.
std::uint64_t ulpDistance(float a, float b);

/// 3 bytes (sRGB) a pixel, row by row, as a PNG without compression. Throws std::invalid_argument
/// when a side is not positive or `pixels` has another size.
std::vector<std::uint8_t> encodePng(int width, int height, std::span<const std::uint8_t> pixels);

}  // namespace haarlight::verify
