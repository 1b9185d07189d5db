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

/// A scene's light at any time. Each source is loaded once; skies are made anew when their sun
/// moves.
class MovingLight {
 public:
  /// Loads all sources. Throws InputError. `warnings` gets one line for each thing unusual.
  MovingLight(const LightDescription& description, std::vector<std::string>& warnings);

  bool moves() const { return description_.motion.has_value(); }

  /// Brings `light` to a second; returns whether it differs from the light of the call before.
  /// Projecting it onto the cube takes most of the time: without `ontoCube` the projection stays
  /// that of an earlier light.
  bool show(double seconds, SceneLight& light, bool ontoCube = true);

 private:
  std::shared_ptr<const Environment> environmentOf(const LightSource& source,
                                                   const SkySettings& sky);
  std::shared_ptr<const Environment> environmentAt(const LightState& state);

  LightDescription description_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const Environment>> environments_;
  /// By source: the sky that was made last, and for which settings.
  std::map<std::string, std::pair<SkySettings, std::shared_ptr<const Environment>>> skies_;
  std::optional<LightState> shown_;
  bool isOnCube_ = false;  ///< the light that is shown
};

}  // namespace haarlight
