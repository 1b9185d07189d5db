#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "verify/report/report.h"

namespace haarlight::verify {

/// A fault put into one engine's results, to show that it is found.
enum class InjectionKind {
  /// One bit of a bit cube is turned.
  bit,
  /// One Haar coefficient is moved to the next float32 number.
  coefficient,
  /// One channel of a radiance is moved to the next float32 number.
  ulp,
  /// One radiance is summed in another order.
  order
};

struct Injection {
  InjectionKind kind = InjectionKind::bit;
  std::string engine;
};

/// "bit", "coefficient", "ulp" or "order". Throws InputError for another word.
InjectionKind injectionKind(const std::string& name);
std::string nameOf(InjectionKind kind);

/// Where faults have been put.
struct InjectedFault {
  std::string caseName;
  std::size_t sample = 0;
  Place place;

  auto operator<=>(const InjectedFault&) const = default;
};

/// An engine that answers as `engine` does, but for one value in every result of the stage that the
/// kind of fault belongs to.
class FaultyEngine final : public Engine {
 public:
  FaultyEngine(std::unique_ptr<Engine> engine, InjectionKind kind);

  /// The following results belong to this case.
  void beginCase(const std::string& caseName) { caseName_ = caseName; }
  const std::vector<InjectedFault>& faults() const { return faults_; }

  std::string name() const override { return engine_->name(); }
  std::string deviceName() const override { return engine_->deviceName(); }
  std::string numericLimitation() const override { return engine_->numericLimitation(); }
  void setShading(const ShadingTables& tables) override;
  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override;
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override;
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override;
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override;
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override;

 private:
  std::size_t choose(std::size_t count);
  void moveByOneUlp(std::vector<glm::vec4>& radiance);
  void reorder(std::vector<glm::vec4>& radiance, std::span<const OcclusionHaar> occlusion,
               std::span<const LobeBlend> lobes);

  std::unique_ptr<Engine> engine_;
  InjectionKind kind_;
  ShadingTables tables_;
  std::string caseName_;
  std::size_t calls_ = 0;
  std::vector<InjectedFault> faults_;
};

}  // namespace haarlight::verify
