#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "spheres/enclosing_ball.h"

namespace haarlight {

/// Whether the point lies in the ball, up to the rounding of a radius that was measured to it.
inline bool covers(const Ball& ball, const glm::vec3& point) {
  const glm::dvec3 d = glm::dvec3(point) - ball.center;
  return ball.radius >= 0 && glm::dot(d, d) <= ball.radius * ball.radius * (1 + 1e-9);
}

/// Points in an order that keeps neighbours together, in blocks with bounding boxes, so that the
/// points in a ball are found without looking at all others.
class PointBlocks {
 public:
  explicit PointBlocks(std::vector<glm::vec3> points);

  const std::vector<glm::vec3>& points() const { return points_; }
  /// Where each point was in the list that this was made from.
  const std::vector<std::uint32_t>& originalPlaces() const { return originalPlaces_; }

  /// Calls function(index) for every point in the ball, in ascending order.
  template <typename Function>
  void forEachIn(const Ball& ball, const Function& function) const {
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
      if (!covers(ball,
                  glm::clamp(glm::vec3(ball.center), boxes_[block].lower, boxes_[block].upper)))
        continue;
      const std::size_t end = std::min(points_.size(), (block + 1) * blockSize);
      for (std::size_t i = block * blockSize; i < end; ++i)
        if (covers(ball, points_[i])) function(static_cast<std::uint32_t>(i));
    }
  }

 private:
  static constexpr std::size_t blockSize = 64;
  struct Box {
    glm::vec3 lower, upper;
  };
  std::vector<glm::vec3> points_;
  std::vector<std::uint32_t> originalPlaces_;
  std::vector<Box> boxes_;
};

}  // namespace haarlight
