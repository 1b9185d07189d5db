#pragma once

#include <span>

#include "shadow/occlusion_query.h"
#include "shadow/shadow_light.h"
#include "solids/solid.h"

namespace haarlight {

/// Whether a solid stands in the way of light to a point. From its own surface, only what comes
/// 10⁻⁹ of the solid's size later counts, so that the point does not stand in its own way; a point
/// that faces away from the light is blocked all the same, by what lies between.
bool blocksLight(const Solid& solid, const glm::dvec3& point, const ShadowLight& light,
                 bool leavesSolid);

/// Rays against solids by their formulas; ray.caster counts in `solids`, which must stay.
class SolidOcclusion final : public OcclusionQuery {
 public:
  SolidOcclusion(std::span<const Solid> solids, const ShadowLight& light)
      : solids_(solids), light_(light) {}

  void answerHere(std::span<const OcclusionRay> rays,
                  std::span<std::uint8_t> blocked) const override;

 private:
  std::span<const Solid> solids_;
  ShadowLight light_;
};

}  // namespace haarlight
