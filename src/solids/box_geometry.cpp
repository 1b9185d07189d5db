#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "solids/shape_geometry.h"

namespace haarlight {

bool containsPoint(const BoxShape& shape, const glm::dvec3& point) {
  return glm::all(glm::lessThanEqual(glm::abs(point), (1 + onSurface) * shape.halfSizes));
}

glm::dvec3 furthestPoint(const BoxShape& shape, const glm::dvec3& direction) {
  glm::dvec3 corner;
  for (int axis = 0; axis < 3; ++axis)
    corner[axis] = std::copysign(shape.halfSizes[axis], direction[axis]);
  return corner;
}

SurfaceCrossings crossings(const BoxShape& shape, const CenteredLine& line) {
  Chord chord;
  for (int axis = 0; axis < 3; ++axis) chord.cutBySlab(line, axis, shape.halfSizes[axis]);
  return chord.ends();
}

}  // namespace haarlight
