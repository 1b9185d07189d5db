#pragma once

/// Spheres at random, for tests.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

#include "mesh/random.h"
#include "visibility/sphere.h"

namespace haarlight::test {

inline glm::dvec3 randomDirection(Random& random) {
  const double z = 2 * random.uniform() - 1, flat = std::sqrt(1 - z * z);
  const double angle = 2 * std::numbers::pi * random.uniform();
  return {flat * std::cos(angle), flat * std::sin(angle), z};
}

/// Spheres all over a ball of radius `extent` around `center`.
inline std::vector<Sphere> randomSpheres(std::size_t count, std::uint64_t seed, double extent = 1,
                                         const glm::dvec3& center = {}) {
  Random random(seed);
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = extent * (0.2 + random.uniform()) / std::cbrt(double(count));
    const glm::dvec3 offset = randomDirection(random) * (extent * std::cbrt(random.uniform()));
    spheres.push_back({glm::vec3(center + offset), static_cast<float>(size)});
  }
  return spheres;
}

/// The spheres after a twist around the z axis, those at greater x larger.
inline std::vector<Sphere> twisted(std::vector<Sphere> spheres) {
  for (Sphere& sphere : spheres) {
    const glm::vec3 c = sphere.center;
    const float cosine = std::cos(c.z), sine = std::sin(c.z);
    sphere = {{cosine * c.x - sine * c.y, sine * c.x + cosine * c.y, c.z},
              sphere.radius * (1 + 0.5f * c.x)};
  }
  return spheres;
}

}  // namespace haarlight::test
