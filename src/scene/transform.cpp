#include "scene/transform.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "base/error.h"

namespace haarlight {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

glm::dmat4 fitMatrix(double size, std::span<const glm::vec3> positions) {
  glm::dvec3 low(infinity), high(-infinity);
  for (const glm::vec3& position : positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  const glm::dvec3 extent = high - low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (!(longest > 0))
    throw InputError("transform.fit: the mesh has no extent that could be scaled");
  return glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(size / longest)), -(low + high) / 2.0);
}

double lowestHeight(const glm::dmat4& matrix, std::span<const glm::vec3> positions) {
  double lowest = infinity;
  for (const glm::vec3& position : positions)
    lowest = std::min(lowest, (matrix * glm::dvec4(position, 1)).y);
  return lowest;
}

/// `fit`, `scale` and `rotateDegrees`.
glm::dmat4 turningMatrix(const TransformDescription& transform,
                         std::span<const glm::vec3> positions) {
  const glm::dvec3 angles = glm::radians(transform.rotateDegrees);
  glm::dmat4 matrix(1);
  matrix = glm::rotate(matrix, angles.z, {0, 0, 1});
  matrix = glm::rotate(matrix, angles.y, {0, 1, 0});
  matrix = glm::rotate(matrix, angles.x, {1, 0, 0});
  matrix = glm::scale(matrix, transform.scale);
  if (transform.fit) matrix = matrix * fitMatrix(*transform.fit, positions);
  return matrix;
}

/// `rest` and `translate`, for points that went through `turning`.
glm::dvec3 offsetOf(const TransformDescription& transform, const glm::dmat4& turning,
                    std::span<const glm::vec3> positions, double groundHeight) {
  glm::dvec3 offset = transform.translate;
  if (transform.rest == Rest::Ground && !positions.empty())
    offset.y += groundHeight - lowestHeight(turning, positions);
  return offset;
}

}  // namespace

glm::dmat4 objectToWorld(const TransformDescription& transform,
                         std::span<const glm::vec3> positions, double groundHeight) {
  const glm::dmat4 turning = turningMatrix(transform, positions);
  return glm::translate(glm::dmat4(1), offsetOf(transform, turning, positions, groundHeight)) *
         turning;
}

glm::dvec3 objectPivot(const TransformDescription& transform, std::span<const glm::vec3> positions,
                       double groundHeight) {
  return offsetOf(transform, turningMatrix(transform, positions), positions, groundHeight);
}

double groundHeight(const SceneDescription& scene) {
  return scene.receiver ? scene.receiver->center.y : 0;
}

}  // namespace haarlight
