#include "scene/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace haarlight {

std::optional<FieldProblem> sightProblem(const CameraDescription& camera) {
  const glm::dvec3 sight = camera.target - camera.position;
  const double smallestSine = 1e-6;
  if (sight == glm::dvec3(0)) return FieldProblem{"target", "must differ from the position"};
  if (glm::length(glm::cross(sight, camera.up)) <=
      smallestSine * glm::length(sight) * glm::length(camera.up))
    return FieldProblem{"up", "must not be zero or parallel to the line from position to target"};
  return std::nullopt;
}

Camera::Camera(const CameraDescription& description, int width, int height)
    : position_(description.position) {
  const glm::dvec3 forward = glm::normalize(description.target - description.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, description.up));
  const glm::dvec3 upward = glm::cross(right, forward);
  const double halfHeight = std::tan(glm::radians(description.verticalFieldOfViewDegrees) / 2);
  const double pixelSize = 2 * halfHeight / height;
  topLeft_ = forward + halfHeight * upward - (pixelSize * width / 2) * right;
  columnStep_ = pixelSize * right;
  rowStep_ = -pixelSize * upward;
}

glm::dvec3 Camera::direction(double x, double y) const {
  return glm::normalize(topLeft_ + x * columnStep_ + y * rowStep_);
}

}  // namespace haarlight
