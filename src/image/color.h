#pragma once

#include <glm/vec3.hpp>

namespace haarlight {

/// Luminance of linear RGB with Rec. 709 primaries (ITU-R BT.709).
inline double luminance(const glm::dvec3& color) {
  return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

}  // namespace haarlight
