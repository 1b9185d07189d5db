#include "engine/self_test.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/forwarding_engine.h"
#include "test_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// An engine that gets one thing wrong.
class WrongEngine final : public ForwardingEngine {
 public:
  enum class Fault { none, sphere, bit, coefficient, sum, radiance };

  WrongEngine(std::unique_ptr<Engine> engine, Fault fault)
      : ForwardingEngine(std::move(engine)), fault_(fault) {}

  std::vector<Sphere> moveSpheres(std::span<const glm::vec4> positions) override {
    auto spheres = engine_->moveSpheres(positions);
    float& radius = spheres.back().radius;
    if (fault_ == Fault::sphere) radius = std::nextafter(radius, 0.0f);
    return spheres;
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
    auto radiance = engine_->tripleProduct(occlusion, lobes);
    if (fault_ == Fault::sum) radiance[1].z = std::nextafter(radiance[1].z, 1.0f);
    return radiance;
  }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override {
    auto radiance = engine_->shade(spheres, receivers, times);
    if (fault_ == Fault::radiance) radiance[2].y = std::nextafter(radiance[2].y, 1.0f);
    return radiance;
  }

 private:
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

TEST_CASE("the self test notices one wrong sphere, bit, coefficient or last digit") {
  CHECK(failureWith(WrongEngine::Fault::none) == "");
  CHECK(failureWith(WrongEngine::Fault::sphere).find("moved spheres") != std::string::npos);
  CHECK(failureWith(WrongEngine::Fault::bit).find("bit cubes") != std::string::npos);
  CHECK(failureWith(WrongEngine::Fault::coefficient).find("Haar") != std::string::npos);
  CHECK(failureWith(WrongEngine::Fault::sum).find("triple product") != std::string::npos);
  CHECK(failureWith(WrongEngine::Fault::radiance).find("radiance") != std::string::npos);
}
