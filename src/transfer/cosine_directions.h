#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace haarlight {

/// Directions over a hemisphere that are as dense as the cosine of the angle to its axis, so that
/// each stands for the same part of an integral: 1/π ∫ f cos ≈ mean of f.
///
/// Projected along the axis they are a sunflower on the disc (Vogel 1979): point i of N lies at
/// radius √((i + shift)/N) and turns by the golden angle from point to point. That spreads any
/// number of points evenly. Over random turns and shifts the mean is without bias.
class CosineDirections {
 public:
  /// Throws std::invalid_argument unless count ≥ 1.
  explicit CosineDirections(int count);

  int count() const { return static_cast<int>(points_.size()); }

  /// Unit directions about a unit axis to the first count() of `directions`. `turn` and `shift` lie
  /// in [0, 1). Directions that follow each other lie together, as packets of rays like it.
  void about(const glm::vec3& axis, float turn, float shift, std::span<glm::vec3> directions) const;

 private:
  struct Point {
    glm::vec2 azimuth;  ///< cosine and sine
    float rank;         ///< i
  };
  std::vector<Point> points_;
};

}  // namespace haarlight
