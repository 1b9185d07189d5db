#include <chrono>
#include <glm/vec3.hpp>
#include <optional>

#include "engine/engine.h"
#include "engine/reference/exponentiation_shader.h"
#include "engine/reference/sample_shader.h"
#include "engine/reference/transfer_shader.h"
#include "visibility/exact_visibility.h"

namespace haarlight {

namespace {

/// Adds the seconds since the last call to one of the stages.
class StageClock {
 public:
  void lap(double& stage) {
    const auto now = std::chrono::steady_clock::now();
    stage += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class ReferenceEngine final : public Engine {
 public:
  explicit ReferenceEngine(std::shared_ptr<const SphereTable> table) : table_(std::move(table)) {}

  std::string name() const override { return "reference"; }
  std::string deviceName() const override { return "scalar C++, one thread"; }

  void setShading(const ShadingTables& tables) override { tables_ = tables; }

  void setSphereBinding(const SphereBinding& binding) override { binding_ = binding; }

  std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) override {
    return haarlight::moveSpheres(binding_, positions);
  }

  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override {
    std::vector<std::uint32_t> entries;
    for (std::size_t i = 0; i < receivers.size(); ++i)
      for (const Sphere& sphere : spheres)
        entries.push_back(
            std::uint32_t(sphereTableEntry(sphere, receivers.positions[i], receivers.normals[i])));
    return entries;
  }

  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override {
    std::vector<BitCube> cubes;
    for (std::size_t i = 0; i < receivers.size(); ++i)
      cubes.push_back(merge(spheres, receivers.positions[i], receivers.normals[i]));
    return cubes;
  }

  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override {
    std::vector<OcclusionHaar> occlusion;
    for (const BitCube& cube : cubes) occlusion.push_back(haarlight::transformOcclusion(cube));
    return occlusion;
  }

  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override {
    std::vector<glm::vec4> radiance;
    for (std::size_t i = 0; i < occlusion.size(); ++i)
      radiance.push_back(SampleShader(tables_, occlusion[i]).radiance(lobes[i]));
    return radiance;
  }

  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override {
    StageTimes ignored;
    StageTimes& stages = times ? *times : ignored;
    StageClock clock, whole;
    std::vector<glm::vec4> radiance;
    radiance.reserve(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const BitCube cube = merge(spheres, receivers.positions[i], receivers.normals[i]);
      clock.lap(stages.merge);
      const OcclusionHaar occlusion = haarlight::transformOcclusion(cube);
      clock.lap(stages.transform);
      radiance.push_back(SampleShader(tables_, occlusion).radiance(receivers.lobes[i]));
      clock.lap(stages.tripleProduct);
    }
    whole.lap(stages.total);
    return radiance;
  }

  void setExponentiation(const ExponentiationTables& tables) override { exponentiation_ = tables; }

  std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                               ReceiverSpan receivers, StageTimes* times) override {
    StageTimes ignored;
    StageTimes& stages = times ? *times : ignored;
    StageClock clock, whole;
    const ExponentiationShader shader(exponentiation_.value());
    std::vector<glm::vec4> radiance;
    radiance.reserve(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i)
      radiance.push_back(shader.radiance(spheres, receivers.positions[i], receivers.normals[i],
                                         receivers.lobes[i]));
    clock.lap(stages.fused);
    whole.lap(stages.total);
    return radiance;
  }

  void setTransferRows(const TransferRows& rows) override { transferRows_ = rows; }
  void setTransferLights(const TransferLights& lights) override { transferLights_ = lights; }

  std::vector<glm::vec4> shadeByTransfer(const TransferReceivers& receivers,
                                         StageTimes* times) override {
    requireTransfer(transferRows_.order, transferRows_.rowCount(), transferLights_, receivers);
    StageTimes ignored;
    StageTimes& stages = times ? *times : ignored;
    StageClock clock, whole;
    const TransferShader shader(transferRows_, transferLights_);
    const std::size_t lights = transferLights_.count();
    std::vector<glm::vec4> radiance;
    radiance.reserve(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i)
      radiance.push_back(shader.radiance(
          receivers.blends[i], std::span(receivers.lightWeights).subspan(i * lights, lights)));
    clock.lap(stages.fused);
    whole.lap(stages.total);
    return radiance;
  }

 private:
  BitCube merge(std::span<const Sphere> spheres, const glm::vec3& position,
                const glm::vec3& normal) const {
    return table_ ? table_->bitCube(spheres, position, normal)
                  : exactBitCube(spheres, position, normal);
  }

  std::shared_ptr<const SphereTable> table_;
  ShadingTables tables_;
  SphereBinding binding_;
  std::optional<ExponentiationTables> exponentiation_;
  TransferRows transferRows_;
  TransferLights transferLights_;
};

}  // namespace

std::unique_ptr<Engine> makeReferenceEngine(std::shared_ptr<const SphereTable> table) {
  return std::make_unique<ReferenceEngine>(std::move(table));
}

}  // namespace haarlight
