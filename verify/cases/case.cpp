#include "verify/cases/case.h"

#include <algorithm>
#include <cmath>

namespace haarlight::verify {

namespace {

bool isMinute(float value) {
  return value != 0 && std::abs(value) < 0x1p-50f;
}

bool isMinute(const Sphere& sphere, const glm::vec3& position, const glm::vec3& normal) {
  const glm::vec3 d = sphere.center - position;
  const float height = (d.x * normal.x + d.y * normal.y) + d.z * normal.z;
  return isMinute(d.x) || isMinute(d.y) || isMinute(d.z) || isMinute(height) ||
         isMinute(sphere.radius);
}

}  // namespace

bool involvesDenormals(const std::vector<Sphere>& spheres, const Receivers& receivers) {
  for (std::size_t i = 0; i < receivers.size(); ++i)
    if (std::ranges::any_of(spheres, [&](const Sphere& sphere) {
          return isMinute(sphere, receivers.positions[i], receivers.normals[i]);
        }))
      return true;
  return false;
}

}  // namespace haarlight::verify
