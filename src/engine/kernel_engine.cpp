#include "engine/kernel_engine.h"

#include <algorithm>

#include "base/canonical_order.h"
#include "base/stopwatch.h"
#include "engine/steps/bound_spheres.h"
#include "engine/steps/exponentiation_path.h"
#include "engine/steps/fused_path.h"
#include "engine/steps/staged_path.h"
#include "engine/steps/transfer_path.h"

namespace haarlight {

namespace {

class KernelEngine final : public Engine {
 public:
  KernelEngine(std::unique_ptr<KernelDevice> device, const SphereTable* table, FramePath path);

  std::string name() const override { return queue_.device().engineName(); }
  std::string deviceName() const override { return queue_.device().name(); }
  std::string numericLimitation() const override { return queue_.device().numericLimitation(); }
  double preparationSeconds() const override { return preparationSeconds_; }
  DeviceUse deviceUse() const override;

  void setShading(const ShadingTables& tables) override;
  void setSphereBinding(const SphereBinding& binding) override { boundSpheres_.set(binding); }
  std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) override {
    return boundSpheres_.move(positions);
  }
  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override {
    frame_.uploadSpheres(spheres);
    return staged_.sphereTableEntries(receivers);
  }
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override {
    frame_.uploadSpheres(spheres);
    return staged_.mergeBitCubes(receivers);
  }
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override {
    return staged_.transformOcclusion(cubes);
  }
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override {
    return staged_.tripleProduct(occlusion, lobes);
  }
  void setFramePath(FramePath path) override { path_ = path; }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override;
  void setExponentiation(const ExponentiationTables& tables) override;
  std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                               ReceiverSpan receivers, StageTimes* times) override {
    return shadeInBatches(exponentiation_, spheres, receivers, times);
  }
  void setTransferRows(const TransferRows& rows) override { transfer_.setRows(rows); }
  void setTransferLights(const TransferLights& lights) override { transfer_.setLights(lights); }
  std::vector<glm::vec4> shadeByTransfer(const TransferReceivers& receivers,
                                         StageTimes* times) override;

 private:
  template <typename Path>
  std::vector<glm::vec4> shadeInBatches(Path& path, std::span<const Sphere> spheres,
                                        ReceiverSpan receivers, StageTimes* times);
  void warmUp();

  KernelQueue queue_;
  FrameBuffers frame_;
  ShadingBuffers shading_{queue_};
  BoundSpheres boundSpheres_{queue_};
  StagedPath staged_{queue_, frame_, shading_};
  FusedPath fused_{queue_, frame_, shading_};
  ExponentiationPath exponentiation_{queue_, frame_};
  TransferPath transfer_{queue_};
  FramePath path_;
  double preparationSeconds_ = 0;
};

KernelEngine::KernelEngine(std::unique_ptr<KernelDevice> device, const SphereTable* table,
                           FramePath path)
    : queue_(std::move(device)), frame_(queue_, table), path_(path) {
  const Stopwatch watch;
  warmUp();
  preparationSeconds_ = queue_.device().buildSeconds() + watch.total();
}

/// Some drivers (PoCL) compile a kernel when it is first launched.
void KernelEngine::warmUp() {
  Receivers receivers;
  receivers.add({0, 0, 0}, {0, 1, 0});
  setShading(buildShadingTables(RadianceCube{}, {0, 2}, countLobes(receivers.lobes)));
  const Sphere sphere{{0, 2, 0}, 1};
  SphereBinding binding;
  binding.add(std::array{0u}, std::array{glm::vec4(1, 1, 0, 0)}, {1, 0});
  setSphereBinding(binding);
  moveSpheres(receivers.positions);
  setSphereBinding({});
  shade(std::span(&sphere, 1), receivers, nullptr);
}

DeviceUse KernelEngine::deviceUse() const {
  DeviceUse use;
  use.memoryBytes = queue_.allocatedBytes();
  const KernelShape shape = queue_.device().shape();
  use.itemsPerGroup = partialSums / shape.lanesPerItem * shape.samplesPerGroup;
  for (const std::string_view kernel : kernelNames)
    if (const auto bytes = queue_.device().localBytes(kernel))
      use.kernels.push_back({std::string(kernel), *bytes});
  return use;
}

void KernelEngine::setShading(const ShadingTables& tables) {
  shading_.set(tables);
  fused_.shadingChanged();
}

/// Its kernel, too, runs once when it is first known that somebody wants it.
void KernelEngine::setExponentiation(const ExponentiationTables& tables) {
  const bool isFirst = !exponentiation_.isSet();
  exponentiation_.set(tables);
  if (!isFirst) return;
  Receivers receivers;
  receivers.add({0, 0, 0}, {0, 1, 0});
  shadeByExponentiation({}, receivers, nullptr);
}

std::vector<glm::vec4> KernelEngine::shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                           StageTimes* times) {
  return path_ == FramePath::fused ? shadeInBatches(fused_, spheres, receivers, times)
                                   : shadeInBatches(staged_, spheres, receivers, times);
}

template <typename Path>
std::vector<glm::vec4> KernelEngine::shadeInBatches(Path& path, std::span<const Sphere> spheres,
                                                    ReceiverSpan receivers, StageTimes* times) {
  StageTimes ignored;
  StageTimes& stages = times ? *times : ignored;
  const Stopwatch watch;
  frame_.uploadSpheres(spheres);
  std::vector<glm::vec4> radiance(receivers.size());
  for (std::size_t first = 0; first < receivers.size(); first += path.batchSize()) {
    const std::size_t count = std::min(path.batchSize(), receivers.size() - first);
    path.shade(receivers.part(first, count), std::span(radiance).subspan(first, count), stages);
  }
  stages.total += watch.total();
  return radiance;
}

std::vector<glm::vec4> KernelEngine::shadeByTransfer(const TransferReceivers& receivers,
                                                     StageTimes* times) {
  StageTimes ignored;
  StageTimes& stages = times ? *times : ignored;
  const Stopwatch watch;
  auto radiance = transfer_.shade(receivers, stages);
  stages.total += watch.total();
  return radiance;
}

}  // namespace

std::unique_ptr<Engine> makeKernelEngine(std::unique_ptr<KernelDevice> device,
                                         std::shared_ptr<const SphereTable> table, FramePath path) {
  return std::make_unique<KernelEngine>(std::move(device), table.get(), path);
}

}  // namespace haarlight
