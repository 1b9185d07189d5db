#include "shadow/solid_occlusion.h"

#include <glm/geometric.hpp>

namespace haarlight {

bool blocksLight(const Solid& solid, const glm::dvec3& point, const ShadowLight& light,
                 bool leavesSolid) {
  Ray ray = segmentToLight(point, light);
  if (leavesSolid) {
    const AxisBox box = solid.bounds();
    constexpr double relativeOffset = 1e-9;
    ray.near = relativeOffset * glm::distance(box.lower, box.upper) / glm::length(ray.direction);
  }
  return solid.blocks(ray);
}

void SolidOcclusion::answerHere(std::span<const OcclusionRay> rays,
                                std::span<std::uint8_t> blocked) const {
  for (std::size_t i = 0; i < rays.size(); ++i)
    blocked[i] = blocksLight(solids_[rays[i].caster], rays[i].from, light_, rays[i].leavesCaster);
}

}  // namespace haarlight
