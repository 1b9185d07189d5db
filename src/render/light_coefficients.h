#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/transfer_tables.h"
#include "render/scene.h"
#include "sh/vector.h"

namespace haarlight {

/// The lights of a scene in spherical harmonics. A light is projected once, as it is before it is
/// turned; turning it turns its coefficients.
class LightCoefficients {
 public:
  explicit LightCoefficients(int order) : order_(order) {}

  /// Turned and scaled: the light samples, or where there are none the light itself.
  TransferLights of(const SceneLight& light);

 private:
  using Source = std::shared_ptr<const Environment>;
  const ShVector<glm::vec3>& projected(std::size_t place, const Source& environment);

  int order_;
  /// By place among the lights: what was projected last.
  std::vector<std::pair<Source, ShVector<glm::vec3>>> projected_;
};

/// How much each of the lights of LightCoefficients shines on a point: one has all; several go by
/// 1/d², Σ = 1, and at the place of one that one alone. `weights`: one for each light.
void weighLights(const SceneLight& light, const glm::vec3& position, std::span<float> weights);

}  // namespace haarlight
