#pragma once

#include <memory>
#include <span>

#include "app/options.h"
#include "hard_shadow/level_of_detail.h"
#include "image/compare.h"
#include "image/write_image.h"
#include "render/moving_scene.h"
#include "render/radiance_method.h"

namespace haarlight {

/// Seconds that bringing a scene to another time took.
struct ShowTimes {
  double meshes = 0;   ///< vertices, normals
  double spheres = 0;  ///< moved with them, by the engine where there is one
  double light = 0;    ///< projection and tables, next to nothing while the light stays; octrees
};

/// A scene on the way to pictures: what render and bake have in common.
class ShadingSetup {
 public:
  ShadingSetup(const SceneOptions& options, SceneDescription description, Console& console);

  const SceneDescription& description() const { return description_; }
  const Scene& scene() const { return moving_.scene(); }
  /// Whether anything changes over time.
  bool moves() const { return moving_.moves(); }
  Console& console() { return console_; }

  /// Throws InputError when the scene's method is sh and an object moves: transfer is for one pose.
  void requireStillObjects() const;

  /// The scene's method, or another; the engine is opened when the method needs it.
  std::unique_ptr<RadianceMethod> method(ShadingMethod which,
                                         std::span<const SurfaceSample> typicalSamples,
                                         bool anyNormal);

  /// Brings the scene to a second (it starts at 0) and tells a method made by method() so.
  ShowTimes show(double seconds, RadianceMethod& method);

  /// What every result says about how it was made.
  nlohmann::ordered_json summary(const RadianceMethod& method) const;

  /// The same as attributes of an EXR file.
  ImageAttributes attributes(const RadianceMethod& method) const;

 private:
  /// Without punctual lights.
  std::unique_ptr<RadianceMethod> environmentMethod(ShadingMethod which,
                                                    std::span<const SurfaceSample> typicalSamples,
                                                    bool anyNormal);
  std::shared_ptr<const SceneTransfer> transfer();

  const SceneOptions& options_;
  SceneDescription description_;
  Console& console_;
  MovingScene moving_;
  std::shared_ptr<const SphereTable> table_;
  std::shared_ptr<Engine> engine_;
  std::optional<LevelOfDetail> shadowDetail_;  ///< once it is needed; the same for all frames
  std::shared_ptr<const SceneTransfer> transfer_;
  double transferSeconds_ = 0;  ///< reading or computing it took
};

nlohmann::ordered_json describeStages(const StageTimes& times);

/// Figures of a comparison: errors of `methodName`'s radiance against `referenceName`'s.
nlohmann::ordered_json describeError(const ImageError& error, const std::string& referenceName);

/// Adds --compare-to to a command.
void addCompareOption(CLI::App& command, std::vector<std::string>& methods);

}  // namespace haarlight
