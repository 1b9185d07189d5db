#pragma once

#include <memory>
#include <span>

#include "app/options.h"
#include "image/compare.h"
#include "image/write_image.h"
#include "render/radiance_method.h"

namespace haarlight {

/// A scene on the way to pictures: what render and bake have in common.
class ShadingSetup {
 public:
  ShadingSetup(const SceneOptions& options, SceneDescription description, Console& console);

  const SceneDescription& description() const { return description_; }
  const Scene& scene() const { return scene_; }
  Console& console() { return console_; }

  /// The scene's method, or another; the engine is opened when the method needs it.
  std::unique_ptr<RadianceMethod> method(ShadingMethod which,
                                         std::span<const SurfaceSample> typicalSamples,
                                         bool anyNormal);

  /// What every result says about how it was made.
  nlohmann::ordered_json summary(const RadianceMethod& method) const;

  /// The same as attributes of an EXR file.
  ImageAttributes attributes(const RadianceMethod& method) const;

 private:
  const SceneOptions& options_;
  SceneDescription description_;
  Console& console_;
  Scene scene_;
  std::shared_ptr<const SphereTable> table_;
  std::shared_ptr<Engine> engine_;
};

nlohmann::ordered_json describeStages(const StageTimes& times);

/// Figures of a comparison: errors of `methodName`'s radiance against `referenceName`'s.
nlohmann::ordered_json describeError(const ImageError& error, const std::string& referenceName);

/// Adds --compare-to to a command.
void addCompareOption(CLI::App& command, std::vector<std::string>& methods);

}  // namespace haarlight
