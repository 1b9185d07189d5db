#include "solids/line_crossings.h"

#include <cmath>

namespace haarlight {

void Chord::cutBySlab(const CenteredLine& line, int axis, double halfSize) {
  const double point = line.point[axis], direction = line.direction[axis];
  if (direction == 0) {
    if (std::abs(point) > halfSize) clear();
    return;
  }
  glm::dvec3 normal(0);  // of the face where the line leaves
  normal[axis] = std::copysign(1.0, direction);
  const double face = normal[axis] * halfSize;
  enterAt((-face - point) / direction, -normal);
  exitAt((face - point) / direction, normal);
}

SurfaceCrossings Chord::ends() const {
  SurfaceCrossings result;
  if (isEmpty()) return result;
  result.add(enter);
  result.add(exit);
  return result;
}

}  // namespace haarlight
