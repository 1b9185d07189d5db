#include "hard_shadow/level_of_detail.h"

#include <algorithm>

namespace haarlight {

OctreeDepths depthsFor(const LevelOfDetail& detail, const AxisBox& receiver) {
  OctreeDepths depths;
  if (const auto* depth = std::get_if<int>(&detail.boundary))
    depths.boundary = *depth;
  else
    depths.boundary = OctreeCube(receiver).depthForDetail(std::get<double>(detail.boundary));
  depths.interior = std::min(detail.interior, depths.boundary);
  return depths;
}

void checkDetail(const LevelOfDetail& detail) {
  const AxisBox unit{glm::dvec3(0), glm::dvec3(1)};
  OctreeDepths depths = depthsFor(detail, unit);
  depths.interior = detail.interior;
  if (std::holds_alternative<double>(detail.boundary)) depths.boundary = deepestCell;
  checkDepths(depths);
}

}  // namespace haarlight
