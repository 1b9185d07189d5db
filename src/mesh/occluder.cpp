#include "mesh/occluder.h"

namespace haarlight {

AxisBox boundsOf(const Occluder& shape) {
  if (const auto* solid = std::get_if<const Solid*>(&shape)) return (*solid)->bounds();
  AxisBox box;
  for (const glm::vec3& p : std::get<const TriangleMesh*>(shape)->positions)
    box = united(box, {p, p});
  return box;
}

}  // namespace haarlight
