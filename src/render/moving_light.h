#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/scene.h"
#include "scene/keyframes.h"

namespace haarlight {

/// A scene's light at any time. Each source is loaded once; skies are made anew for each second
/// that is shown.
class MovingLight {
 public:
  /// Loads all sources. Throws InputError. `warnings` gets one line for each thing unusual.
  MovingLight(const LightDescription& description, std::vector<std::string>& warnings);

  bool moves() const { return description_.motion.has_value(); }

  /// Brings `light` to a second; returns whether it differs from the light of the call before.
  bool show(double seconds, SceneLight& light);

 private:
  std::shared_ptr<const Environment> environmentOf(const LightSource& source,
                                                   const SkySettings& sky) const;
  std::shared_ptr<const Environment> environmentAt(const LightState& state) const;

  LightDescription description_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const Environment>> environments_;
  std::optional<LightState> shown_;
};

}  // namespace haarlight
