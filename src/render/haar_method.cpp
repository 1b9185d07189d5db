#include "render/engine_method.h"

namespace haarlight {

namespace {

class HaarMethod final : public EngineMethod {
 public:
  HaarMethod(const Scene& scene, std::shared_ptr<Engine> engine, const ShadingSettings& settings,
             std::span<const SurfaceSample> typicalSamples, bool anyNormal)
      : EngineMethod(scene, std::move(engine), typicalSamples, anyNormal), settings_(settings) {
    sceneChanged(true);
  }

  std::string name() const override { return "haar"; }

 private:
  void setLight(const RadianceCube& light, std::span<const double> lobeImportance) override {
    engine().setShading(buildShadingTables(light, settings_, lobeImportance));
  }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres,
                               const Receivers& receivers) override {
    return engine().shade(spheres, receivers, &times_);
  }

  ShadingSettings settings_;
};

}  // namespace

std::unique_ptr<RadianceMethod> makeHaarMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                                               const ShadingSettings& settings,
                                               std::span<const SurfaceSample> typicalSamples,
                                               bool anyNormal) {
  return std::make_unique<HaarMethod>(scene, std::move(engine), settings, typicalSamples,
                                      anyNormal);
}

}  // namespace haarlight
