#include "verify/cases/case.h"

#include <algorithm>
#include <cmath>

namespace haarlight::verify {

namespace {

bool isMinute(float value) {
  return value != 0 && std::abs(value) < 0x1p-50f;
}

bool isMinute(const glm::vec3& d) {
  return isMinute(d.x) || isMinute(d.y) || isMinute(d.z);
}

bool isMinute(const Sphere& sphere, const glm::vec3& position, const glm::vec3& normal) {
  const glm::vec3 d = sphere.center - position;
  const float height = (d.x * normal.x + d.y * normal.y) + d.z * normal.z;
  return isMinute(d) || isMinute(height) || isMinute(sphere.radius);
}

bool anyMinute(const std::vector<Sphere>& spheres, const Receivers& receivers) {
  for (std::size_t i = 0; i < receivers.size(); ++i)
    if (std::ranges::any_of(spheres, [&](const Sphere& sphere) {
          return isMinute(sphere, receivers.positions[i], receivers.normals[i]);
        }))
      return true;
  return false;
}

/// Of what is computed on the way to the moved spheres.
bool anyMinute(const SphereBinding& binding, const std::vector<glm::vec4>& vertices) {
  const std::vector<Sphere> moved = moveSpheres(binding, vertices);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const std::size_t first = binding.listStarts[i];
    const glm::vec3 origin = vertices[binding.vertices[first]];
    if (isMinute(moved[i].radius)) return true;
    for (std::size_t entry = first; entry < binding.listStarts[i + 1]; ++entry) {
      const glm::vec3 vertex = vertices[binding.vertices[entry]];
      if (isMinute(glm::vec3(binding.weights[entry])) || isMinute(vertex - origin) ||
          isMinute(vertex - moved[i].center))
        return true;
    }
  }
  return false;
}

}  // namespace

bool involvesDenormals(const Case& value) {
  return anyMinute(value.spheres, value.receivers) || anyMinute(value.binding, value.vertices);
}

}  // namespace haarlight::verify
