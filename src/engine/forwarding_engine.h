#pragma once

#include <memory>
#include <utility>

#include "engine/engine.h"

namespace haarlight {

/// Answers as another engine does; what derives from it answers some calls in its own way.
class ForwardingEngine : public Engine {
 public:
  explicit ForwardingEngine(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

  std::string name() const override { return engine_->name(); }
  std::string deviceName() const override { return engine_->deviceName(); }
  std::string numericLimitation() const override { return engine_->numericLimitation(); }
  double preparationSeconds() const override { return engine_->preparationSeconds(); }
  DeviceUse deviceUse() const override { return engine_->deviceUse(); }
  void setShading(const ShadingTables& tables) override { engine_->setShading(tables); }
  void setSphereBinding(const SphereBinding& binding) override {
    engine_->setSphereBinding(binding);
  }
  std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) override {
    return engine_->moveSpheres(positions);
  }
  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override {
    return engine_->sphereTableEntries(spheres, receivers);
  }
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override {
    return engine_->mergeBitCubes(spheres, receivers);
  }
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override {
    return engine_->transformOcclusion(cubes);
  }
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override {
    return engine_->tripleProduct(occlusion, lobes);
  }
  void setFramePath(FramePath path) override { engine_->setFramePath(path); }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override {
    return engine_->shade(spheres, receivers, times);
  }
  void setExponentiation(const ExponentiationTables& tables) override {
    engine_->setExponentiation(tables);
  }
  std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                               ReceiverSpan receivers, StageTimes* times) override {
    return engine_->shadeByExponentiation(spheres, receivers, times);
  }
  void setTransferRows(const TransferRows& rows) override { engine_->setTransferRows(rows); }
  void setTransferLights(const TransferLights& lights) override {
    engine_->setTransferLights(lights);
  }
  std::vector<glm::vec4> shadeByTransfer(const TransferReceivers& receivers,
                                         StageTimes* times) override {
    return engine_->shadeByTransfer(receivers, times);
  }

 protected:
  std::unique_ptr<Engine> engine_;
};

}  // namespace haarlight
