#include "solids/placement.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"

namespace haarlight {

namespace {

/// The rotation next to `matrix`, by orthogonalising its columns in turn.
glm::dmat3 orthonormalised(const glm::dmat3& matrix) {
  const glm::dvec3 x = glm::normalize(matrix[0]);
  const glm::dvec3 y = glm::normalize(matrix[1] - glm::dot(matrix[1], x) * x);
  return {x, y, glm::cross(x, y)};
}

bool isNear(const glm::dmat3& a, const glm::dmat3& b, double tolerance) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!(std::abs(a[column][row] - b[column][row]) <= tolerance)) return false;
  return true;
}

}  // namespace

Placement::Placement(const glm::dvec3& translation, const glm::dmat3& rotation)
    : rotation_(orthonormalised(rotation)), translation_(translation) {
  if (!isNear(rotation, rotation_, 1e-6))
    throw InputError(
        "a solid's rotation must be a rotation matrix: columns of length 1, at right angles, "
        "without mirroring; measures say how large a solid is");
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(translation[axis]))
      throw InputError("a solid's translation must be three finite numbers");
}

}  // namespace haarlight
