#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "cube/cube_map.h"

namespace haarlight {

/// One value per texel of the cube, in texel order.
template <typename Value>
struct CubeImage {
  std::vector<Value> texels = std::vector<Value>(texelCount, Value{});

  Value& operator[](int texel) { return texels[texel]; }
  const Value& operator[](int texel) const { return texels[texel]; }
};

/// Radiance per texel (mean over the texel's solid angle), linear RGB with Rec. 709 primaries.
using RadianceCube = CubeImage<glm::vec3>;

}  // namespace haarlight
