#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "light/light_integrals.h"

namespace haarlight {

/// An infinitely distant light: radiance by direction. World: y up, right handed.
class Environment {
 public:
  virtual ~Environment() = default;

  /// Radiance (linear RGB, Rec. 709 primaries) that arrives from a direction (any length > 0), for
  /// the background of a picture; images are interpolated bilinearly.
  virtual glm::vec3 radiance(const glm::vec3& direction) const = 0;

  /// One line for people: the file or formula, size and layout.
  virtual std::string description() const = 0;

  /// Integrals over the texels after the light has been turned: what came from d comes from
  /// rotation · d. `rotation` is orthonormal. Does not depend on the number of threads.
  virtual LightIntegrals integrate(const glm::dmat3& rotation) const = 0;
};

}  // namespace haarlight
