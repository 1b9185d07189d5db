#include "mesh/inside_test.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace haarlight {

namespace {

constexpr glm::vec3 directions[] = {{0.5613f, 0.7071f, 0.4301f},
                                    {-0.8297f, 0.2531f, 0.4975f},
                                    {0.3217f, -0.6949f, 0.6431f},
                                    {0.2387f, 0.4129f, -0.8789f},
                                    {-0.4517f, -0.5323f, -0.7159f}};
constexpr int rayCount = std::size(directions);

}  // namespace

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

InsideTest::InsideTest(const TriangleMesh& mesh) : scene_(mesh) {}

bool InsideTest::contains(const glm::vec3& point) const {
  int inside = 0;
  for (int ray = 0; ray < rayCount; ++ray) {
    int turns = 0;
    for (const Crossing& crossing : crossingsAlong(scene_, point, directions[ray]))
      turns += crossing.turn;
    inside += turns != 0;
    const int outside = ray + 1 - inside;
    if (2 * inside > rayCount || 2 * outside > rayCount) break;
  }
  return 2 * inside > rayCount;
}

}  // namespace haarlight
