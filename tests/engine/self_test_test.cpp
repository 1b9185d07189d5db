#include "engine/self_test.h"

#include <doctest/doctest.h>

#include <cmath>

#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// An engine that gets one thing wrong.
class WrongEngine final : public Engine {
 public:
  enum class Fault { none, bit, coefficient, radiance };

  WrongEngine(std::unique_ptr<Engine> engine, Fault fault)
      : engine_(std::move(engine)), fault_(fault) {}

  std::string name() const override { return "wrong"; }
  std::string deviceName() const override { return "test"; }
  void setShading(const ShadingTables& tables) override { engine_->setShading(tables); }
  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override {
    return engine_->sphereTableEntries(spheres, receivers);
  }
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override {
    auto cubes = engine_->mergeBitCubes(spheres, receivers);
    if (fault_ == Fault::bit) cubes.back().rows[100] ^= 1u << 31;
    return cubes;
  }
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override {
    auto occlusion = engine_->transformOcclusion(cubes);
    float& coefficient = occlusion.front().coefficients[77];
    if (fault_ == Fault::coefficient) coefficient = std::nextafter(coefficient, 1.0f);
    return occlusion;
  }
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override {
    return engine_->tripleProduct(occlusion, lobes);
  }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override {
    auto radiance = engine_->shade(spheres, receivers, times);
    if (fault_ == Fault::radiance) radiance[2].y = std::nextafter(radiance[2].y, 1.0f);
    return radiance;
  }

 private:
  std::unique_ptr<Engine> engine_;
  Fault fault_;
};

std::string failureWith(WrongEngine::Fault fault) {
  WrongEngine engine(referenceEngine(), fault);
  return selfTestFailure(engine, nullptr);
}

}  // namespace

TEST_CASE("the scalar engine gives the known answers of the self test") {
  for (const auto visibility : {VisibilityKind::exact, VisibilityKind::table}) {
    const auto engine = referenceEngine(visibility);
    const auto table = visibility == VisibilityKind::table ? sharedSphereTable() : nullptr;
    CHECK(selfTestFailure(*engine, table) == "");
  }
}

TEST_CASE("the self test notices one wrong bit, coefficient or last digit") {
  CHECK(failureWith(WrongEngine::Fault::none) == "");
  CHECK(failureWith(WrongEngine::Fault::bit).find("bit cubes") != std::string::npos);
  CHECK(failureWith(WrongEngine::Fault::coefficient).find("Haar") != std::string::npos);
  CHECK(failureWith(WrongEngine::Fault::radiance).find("radiance") != std::string::npos);
}
