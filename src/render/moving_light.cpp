#include "render/moving_light.h"

#include <algorithm>

#include "light/blended_environment.h"
#include "light/builtin_lights.h"
#include "light/load_light.h"
#include "light/sky_model.h"

namespace haarlight {

namespace {

std::vector<LightSource> sourcesOf(const LightDescription& description) {
  std::vector<LightSource> sources{{description.source, description.layout}};
  if (description.motion)
    for (const LightKey& key : description.motion->keys)
      if (key.source) sources.push_back({*key.source, key.layout});
  for (const LightSampleDescription& sample : description.samples)
    sources.push_back({sample.source, sample.layout});
  return sources;
}

bool isSky(const LightSource& source) {
  return findSky(source.source) != nullptr;
}

/// Whether the description says anything about a sky.
bool placesSun(const LightDescription& light) {
  return light.sky ||
         (light.motion && std::ranges::any_of(light.motion->keys, [](const LightKey& key) {
            return key.sunAzimuthDegrees || key.sunElevationDegrees;
          }));
}

}  // namespace

MovingLight::MovingLight(const LightDescription& description, std::vector<std::string>& warnings)
    : description_(description) {
  const std::vector<LightSource> sources = sourcesOf(description);
  if (placesSun(description) && std::ranges::none_of(sources, isSky))
    warnings.push_back("the scene places a sun, but its light is no sky: " + description.source);
  for (const LightSource& source : sources) {
    auto& environment = environments_[{source.source, source.layout}];
    if (environment) continue;
    LoadedLight loaded = loadLight(source.source, source.layout == "auto" ? "" : source.layout);
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    environment = std::move(loaded.environment);
  }
}

std::shared_ptr<const Environment> MovingLight::environmentOf(const LightSource& source,
                                                              const SkySettings& sky) {
  if (!isSky(source)) return environments_.at({source.source, source.layout});
  auto& [settings, made] = skies_[source.source];
  if (!made || settings != sky) {
    settings = sky;
    made = makeBuiltinLight(source.source, sky);
  }
  return made;
}

std::shared_ptr<const Environment> MovingLight::environmentAt(const LightState& state) {
  auto from = environmentOf(state.from, state.sky);
  if (state.fraction == 0 || state.from == state.to) return from;
  return std::make_shared<BlendedEnvironment>(std::move(from), environmentOf(state.to, state.sky),
                                              state.fraction);
}

bool MovingLight::show(double seconds, SceneLight& light, bool ontoCube) {
  LightState state = lightAt(description_, seconds);
  if (state.from == state.to) state.fraction = 0;
  if (shown_ == state && (isOnCube_ || !ontoCube)) return false;
  shown_ = state;
  light.environment = environmentAt(state);
  light.rotation = yawRotation(state.rotateDegrees);
  light.scale = float(state.scale);
  if (ontoCube) light.projection = projectToCube(*light.environment, light.rotation, light.scale);
  isOnCube_ = ontoCube;
  light.samples.clear();
  for (const LightSampleDescription& sample : description_.samples)
    light.samples.push_back({glm::vec3(sample.position),
                             environmentOf({sample.source, sample.layout}, state.sky),
                             yawRotation(state.rotateDegrees + sample.rotateDegrees),
                             float(state.scale * sample.scale)});
  return true;
}

}  // namespace haarlight
