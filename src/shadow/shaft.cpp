#include "shadow/shaft.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace haarlight {

namespace {

constexpr double relativeMargin = 4e-12;

double largestCoordinate(const glm::dvec3& point) {
  const glm::dvec3 size = glm::abs(point);
  return std::max({size.x, size.y, size.z});
}

}  // namespace

std::array<glm::dvec3, 8> cornersOf(const AxisBox& box) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[i] = {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                  i & 4 ? box.upper.z : box.lower.z};
  return corners;
}

double largestCoordinate(const AxisBox& box) {
  return std::max(largestCoordinate(box.lower), largestCoordinate(box.upper));
}

Shaft::Shaft(const AxisBox& cell, const ShadowLight& light, const AxisBox& scene)
    : cell_(cell), light_(&light), radius_(glm::distance(cell.center(), cell.upper)) {
  double scale = largestCoordinate(united(cell, scene));
  if (const auto* point = std::get_if<PointLight>(&light)) {
    scale = std::max(scale, largestCoordinate(point->position));
    length_ = glm::distance(point->position, center());
    if (length_ > 0) towards_ = (point->position - center()) / length_;
  } else {
    towards_ = glm::normalize(std::get<DirectionalLight>(light).towards);
    const double start = glm::dot(cornerAlong(cell, -towards_), towards_);
    if (!scene.isEmpty())
      length_ = std::max(0.0, glm::dot(cornerAlong(scene, towards_), towards_) - start);
  }
  margin_ = relativeMargin * scale;
}

glm::dvec3 Shaft::support(const glm::dvec3& direction) const {
  const glm::dvec3 corner = cornerAlong(cell_, direction);
  if (const auto* point = std::get_if<PointLight>(light_))
    return glm::dot(point->position - corner, direction) > 0 ? point->position : corner;
  return glm::dot(towards_, direction) > 0 ? corner + length_ * towards_ : corner;
}

double Shaft::radiusAt(double distance) const {
  if (std::holds_alternative<DirectionalLight>(*light_)) return radius_;
  return length_ > 0 ? radius_ * std::max(0.0, 1 - distance / length_) : radius_;
}

double Shaft::spread() const {
  if (std::holds_alternative<DirectionalLight>(*light_)) return 0;
  // Seen from the light, the ball's radius is the sine of the angle; asin(x) ≤ 1.2 x up to 0.8.
  if (radius_ > 0.8 * length_) return std::numeric_limits<double>::infinity();
  return 1.2 * radius_ / length_;
}

}  // namespace haarlight
