#pragma once

#include <glm/vec3.hpp>

namespace haarlight {

/// A sphere that stands in for a piece of a blocker. World units; radius > 0. The layout (16 bytes)
/// is the float4 (x, y, z, radius) that kernels read.
struct Sphere {
  glm::vec3 center;
  float radius;
};
static_assert(sizeof(Sphere) == 16);

}  // namespace haarlight
