#include "shadow/solid_occlusion.h"

#include <glm/geometric.hpp>

#include "base/parallel.h"

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

void SolidOcclusion::answer(std::span<const OcclusionRay> rays,
                            std::span<std::uint8_t> blocked) const {
  constexpr std::size_t grain = 256;
  parallelFor(rays.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      blocked[i] = blocksLight(solids_[rays[i].caster], rays[i].from, light_, rays[i].leavesCaster);
  });
}

}  // namespace haarlight
