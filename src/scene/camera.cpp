#include "scene/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace haarlight {

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
