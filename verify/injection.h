#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/forwarding_engine.h"
#include "verify/report/report.h"

namespace haarlight::verify {

/// A fault put into one engine's results, to show that it is found.
enum class InjectionKind {
  /// One number of a moved sphere is moved to the next float32 number.
  sphere,
  /// One bit of a bit cube is turned.
  bit,
  /// One Haar coefficient is moved to the next float32 number.
  coefficient,
  /// One channel of a radiance is moved to the next float32 number.
  ulp,
  /// The same, of a radiance by exponentiation.
  exponentiation,
  /// The same, of a radiance by transfer.
  transfer
};

struct Injection {
  InjectionKind kind = InjectionKind::bit;
  std::string engine;
};

/// "sphere", "bit", "coefficient", "ulp", "exponentiation" or "transfer". Throws InputError for
/// another word.
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
class FaultyEngine final : public ForwardingEngine {
 public:
  FaultyEngine(std::unique_ptr<Engine> engine, InjectionKind kind);

  /// The following results belong to this case.
  void beginCase(const std::string& caseName) { caseName_ = caseName; }
  const std::vector<InjectedFault>& faults() const { return faults_; }

  std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) override;
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override;
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override;
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override;
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override;
  std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                               ReceiverSpan receivers, StageTimes* times) override;
  std::vector<glm::vec4> shadeByTransfer(const TransferReceivers& receivers,
                                         StageTimes* times) override;

 private:
  std::size_t choose(std::size_t count);
  void moveByOneUlp(std::vector<glm::vec4>& radiance);

  InjectionKind kind_;
  std::string caseName_;
  std::size_t calls_ = 0;
  std::vector<InjectedFault> faults_;
};

}  // namespace haarlight::verify
