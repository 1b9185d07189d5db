#include "light/blended_environment.h"

#include <fmt/format.h>

#include <glm/common.hpp>
#include <utility>

namespace haarlight {

BlendedEnvironment::BlendedEnvironment(std::shared_ptr<const Environment> from,
                                       std::shared_ptr<const Environment> to, double fraction)
    : from_(std::move(from)), to_(std::move(to)), fraction_(fraction) {}

glm::vec3 BlendedEnvironment::radiance(const glm::vec3& direction) const {
  return glm::mix(from_->radiance(direction), to_->radiance(direction), float(fraction_));
}

std::string BlendedEnvironment::description() const {
  return fmt::format("{:.0f} % of {} and {:.0f} % of {}", 100 * (1 - fraction_),
                     from_->description(), 100 * fraction_, to_->description());
}

/// Means over texels are blended, since the two may measure a texel's solid angle by different
/// quadratures.
LightIntegrals BlendedEnvironment::integrate(const glm::dmat3& rotation) const {
  LightIntegrals blend = from_->integrate(rotation);
  const LightIntegrals to = to_->integrate(rotation);
  for (int texel = 0; texel < texelCount; ++texel) {
    const glm::dvec3 toRadiance =
        to.radiance[texel] * (blend.solidAngle[texel] / to.solidAngle[texel]);
    blend.radiance[texel] = glm::mix(blend.radiance[texel], toRadiance, fraction_);
  }
  blend.sourcePower = glm::mix(blend.sourcePower, to.sourcePower, fraction_);
  return blend;
}

}  // namespace haarlight
