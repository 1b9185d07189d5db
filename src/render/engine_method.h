#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/engine.h"
#include "render/radiance_method.h"

namespace haarlight {

/// What the methods that run on an engine have in common: samples become receivers, and the
/// radiance of white ones is multiplied by the albedo.
class EngineMethod : public RadianceMethod {
 public:
  std::string deviceName() const override;
  void sceneChanged(bool lightToo) override;
  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override;

 protected:
  /// A constructor ends with sceneChanged(true). Where `anyNormal` is set, other normals than those
  /// of `typicalSamples` may follow.
  EngineMethod(const Scene& scene, std::shared_ptr<Engine> engine,
               std::span<const SurfaceSample> typicalSamples, bool anyNormal);

  Engine& engine() { return *engine_; }

 private:
  /// Hands the light to the engine; `lobeImportance` says how often each lobe occurs.
  virtual void setLight(const RadianceCube& light, std::span<const double> lobeImportance) = 0;
  /// Radiance of white receivers.
  virtual std::vector<glm::vec4> shade(std::span<const Sphere> spheres,
                                       const Receivers& receivers) = 0;

  const Scene& scene_;
  std::shared_ptr<Engine> engine_;
  std::vector<double> lobeImportance_;
  std::vector<Sphere> spheres_;
};

}  // namespace haarlight
