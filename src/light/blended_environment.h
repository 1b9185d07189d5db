#pragma once

#include <memory>

#include "light/environment.h"

namespace haarlight {

/// A cross-fade: the radiances of two lights in the parts 1 − fraction and fraction.
class BlendedEnvironment final : public Environment {
 public:
  BlendedEnvironment(std::shared_ptr<const Environment> from, std::shared_ptr<const Environment> to,
                     double fraction);

  glm::vec3 radiance(const glm::vec3& direction) const override;
  std::string description() const override;
  LightIntegrals integrate(const glm::dmat3& rotation) const override;

 private:
  std::shared_ptr<const Environment> from_, to_;
  double fraction_;
};

}  // namespace haarlight
