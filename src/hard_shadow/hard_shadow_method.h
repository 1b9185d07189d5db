#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "hard_shadow/scene_octrees.h"
#include "hard_shadow/surface_view.h"

namespace haarlight {

/// A way to find the hard shadows that a picture sees.
class HardShadowMethod {
 public:
  virtual ~HardShadowMethod() = default;

  /// "octree", "classic" or "exact".
  virtual std::string name() const = 0;

  /// Sets inShadow[i] to 1 where the light with this number does not reach the view's point i, and
  /// to 0 elsewhere, also where there is nothing. Uses all threads.
  virtual void answer(std::size_t light, const SurfaceView& view,
                      std::span<std::uint8_t> inShadow) = 0;

  /// The octrees of a light, where there are any.
  virtual const SceneOctrees* octreesOf(std::size_t) const { return nullptr; }

  /// Counts, bytes and seconds so far (docs/lod_shadows.md).
  virtual nlohmann::ordered_json figures() const = 0;
};

// Shapes must stay. What they throw is what SceneOctrees, ClassicShadows and ExactShadows do.

std::unique_ptr<HardShadowMethod> makeOctreeShadows(std::span<const ShadowParticipant> participants,
                                                    std::span<const ShadowLight> lights,
                                                    const LevelOfDetail& detail);

std::unique_ptr<HardShadowMethod> makeClassicShadows(
    std::span<const ShadowParticipant> participants, std::span<const ShadowLight> lights);

std::unique_ptr<HardShadowMethod> makeExactShadows(std::span<const ShadowParticipant> participants,
                                                   std::span<const ShadowLight> lights);

}  // namespace haarlight
