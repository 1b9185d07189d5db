#include "mesh/inside_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace haarlight {

InsideTest::InsideTest(const TriangleMesh& mesh) : windingNumber_(mesh) {}

bool InsideTest::contains(const glm::vec3& point) const {
  return std::abs(windingNumber_(point)) > 0.5f;
}

std::vector<Crossing> crossingsAlong(const RayScene& scene, const glm::vec3& origin,
                                     const glm::vec3& direction) {
  std::vector<Crossing> crossings;
  float near = 0;
  while (const auto hit = scene.closestHit(origin, direction, near)) {
    crossings.push_back({hit->distance, glm::dot(direction, hit->geometricNormal) > 0 ? 1 : -1});
    // Past the rounding of the distance, or the same triangle is met again.
    near = std::nextafter(std::max(near, hit->distance) * (1 + 1e-6f),
                          std::numeric_limits<float>::max());
  }
  return crossings;
}

}  // namespace haarlight
