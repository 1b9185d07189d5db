#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cube/cube_image.h"
#include "engine/receivers.h"
#include "visibility/sphere_binding.h"

namespace haarlight::verify {

/// One question asked of every engine: spheres, receivers and light, and spheres that follow
/// vertices.
struct Case {
  /// "known: one sphere overhead", "random 17", "scene default", …; unique within a run.
  std::string name;
  std::vector<Sphere> spheres;
  Receivers receivers;
  RadianceCube light;
  /// Spheres of their own, not those above; none in many cases. They follow the vertices (x, y, z,
  /// 0), and where they are moved to is what is asked.
  SphereBinding binding;
  std::vector<glm::vec4> vertices;
  /// Spheres so near or far, or receivers or vertices so placed, that distances squared are
  /// denormal numbers: devices that flush those to zero may answer differently.
  bool hasDenormals = false;
  /// Where the receivers are pixels of a picture: its size and every receiver's pixel,
  /// row · width + column. Else 0 and empty.
  int frameWidth = 0, frameHeight = 0;
  std::vector<std::uint32_t> pixels;
};

/// Whether what decides bits about these spheres, receivers and vertices may be a denormal number:
/// a distance along an axis or to a tangent plane, or a radius, below 2⁻⁵⁰ and not 0. (Squares of
/// 2⁻⁶³ are denormal; the margin is for the factors they are multiplied by.)
bool involvesDenormals(const Case& value);

}  // namespace haarlight::verify
