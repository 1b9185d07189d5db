#include "scene/transform.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <optional>

#include "base/error.h"
#include "solids/scaled_shape.h"
#include "solids/solid.h"

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

glm::dmat4 rotationMatrix(const TransformDescription& transform) {
  const glm::dvec3 angles = glm::radians(transform.rotateDegrees);
  glm::dmat4 matrix(1);
  matrix = glm::rotate(matrix, angles.z, {0, 0, 1});
  matrix = glm::rotate(matrix, angles.y, {0, 1, 0});
  return glm::rotate(matrix, angles.x, {1, 0, 0});
}

/// `fit`, `scale` and `rotateDegrees`.
glm::dmat4 turningMatrix(const TransformDescription& transform,
                         std::span<const glm::vec3> positions) {
  const glm::dmat4 matrix = glm::scale(rotationMatrix(transform), transform.scale);
  return transform.fit ? matrix * fitMatrix(*transform.fit, positions) : matrix;
}

glm::dmat4 turningMatrix(const TransformDescription& transform, const Shape&) {
  return glm::scale(rotationMatrix(transform), transform.scale);
}

/// The lowest y after turningMatrix; nothing when there are no points.
std::optional<double> lowestHeight(const TransformDescription& transform,
                                   std::span<const glm::vec3> positions) {
  const glm::dmat4 matrix = turningMatrix(transform, positions);
  std::optional<double> lowest;
  for (const glm::vec3& position : positions) {
    const double height = (matrix * glm::dvec4(position, 1)).y;
    lowest = std::min(lowest.value_or(height), height);
  }
  return lowest;
}

std::optional<double> lowestHeight(const TransformDescription& transform, const Shape& shape) {
  const Placement placement({}, glm::dmat3(rotationMatrix(transform)));
  return Solid(scaled(shape, transform.scale.x), placement).bounds().lower.y;
}

/// `rest` and `translate`. `body` is positions or a shape.
template <typename Body>
glm::dvec3 offsetOf(const TransformDescription& transform, const Body& body, double groundHeight) {
  glm::dvec3 offset = transform.translate;
  if (transform.rest == Rest::Ground)
    if (const auto lowest = lowestHeight(transform, body)) offset.y += groundHeight - *lowest;
  return offset;
}

template <typename Body>
glm::dmat4 matrixOf(const TransformDescription& transform, const Body& body, double groundHeight) {
  return glm::translate(glm::dmat4(1), offsetOf(transform, body, groundHeight)) *
         turningMatrix(transform, body);
}

}  // namespace

glm::dmat4 objectToWorld(const TransformDescription& transform,
                         std::span<const glm::vec3> positions, double groundHeight) {
  return matrixOf(transform, positions, groundHeight);
}

glm::dmat4 solidToWorld(const TransformDescription& transform, const Shape& shape,
                        double groundHeight) {
  return matrixOf(transform, shape, groundHeight);
}

glm::dvec3 objectPivot(const TransformDescription& transform, std::span<const glm::vec3> positions,
                       double groundHeight) {
  return offsetOf(transform, positions, groundHeight);
}

glm::dvec3 solidPivot(const TransformDescription& transform, const Shape& shape,
                      double groundHeight) {
  return offsetOf(transform, shape, groundHeight);
}

double groundHeight(const SceneDescription& scene) {
  return scene.receiver ? scene.receiver->center.y : 0;
}

}  // namespace haarlight
