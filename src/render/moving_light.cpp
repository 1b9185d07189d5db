#include "render/moving_light.h"

#include "light/blended_environment.h"
#include "light/load_light.h"

namespace haarlight {

namespace {

std::vector<LightSource> sourcesOf(const LightDescription& description) {
  std::vector<LightSource> sources{{description.source, description.layout}};
  if (description.motion)
    for (const LightKey& key : description.motion->keys)
      if (key.source) sources.push_back({*key.source, key.layout});
  return sources;
}

}  // namespace

MovingLight::MovingLight(const LightDescription& description, std::vector<std::string>& warnings)
    : description_(description) {
  for (const LightSource& source : sourcesOf(description)) {
    auto& environment = environments_[{source.source, source.layout}];
    if (environment) continue;
    LoadedLight loaded = loadLight(source.source, source.layout == "auto" ? "" : source.layout);
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    environment = std::move(loaded.environment);
  }
}

std::shared_ptr<const Environment> MovingLight::environmentAt(const LightState& state) const {
  const auto from = environments_.at({state.from.source, state.from.layout});
  if (state.fraction == 0 || state.from == state.to) return from;
  return std::make_shared<BlendedEnvironment>(
      from, environments_.at({state.to.source, state.to.layout}), state.fraction);
}

bool MovingLight::show(double seconds, SceneLight& light) {
  LightState state = lightAt(description_, seconds);
  if (state.from == state.to) state.fraction = 0;
  if (shown_ == state) return false;
  shown_ = state;
  light.environment = environmentAt(state);
  light.rotation = yawRotation(state.rotateDegrees);
  light.scale = float(state.scale);
  light.projection = projectToCube(*light.environment, light.rotation, light.scale);
  return true;
}

}  // namespace haarlight
