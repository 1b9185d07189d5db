#include "render/engine_method.h"

namespace haarlight {

namespace {

class ShexpMethod final : public EngineMethod {
 public:
  ShexpMethod(const Scene& scene, std::shared_ptr<Engine> engine, int order,
              std::span<const SurfaceSample> typicalSamples, bool anyNormal)
      : EngineMethod(scene, std::move(engine), typicalSamples, anyNormal), order_(order) {
    sceneChanged(true);
  }

  std::string name() const override { return "shexp"; }

 private:
  void setLight(const RadianceCube& light, std::span<const double> lobeImportance) override {
    engine().setExponentiation(buildExponentiationTables(light, order_, lobeImportance));
  }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres,
                               const Receivers& receivers) override {
    return engine().shadeByExponentiation(spheres, receivers, &times_);
  }

  int order_;
};

}  // namespace

std::unique_ptr<RadianceMethod> makeShexpMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                                                int order,
                                                std::span<const SurfaceSample> typicalSamples,
                                                bool anyNormal) {
  return std::make_unique<ShexpMethod>(scene, std::move(engine), order, typicalSamples, anyNormal);
}

}  // namespace haarlight
