#include "verify/injection.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "verify/places.h"

namespace haarlight::verify {

namespace {

struct NamedKind {
  const char* name;
  InjectionKind kind;
};
constexpr std::array namedKinds{NamedKind{"sphere", InjectionKind::sphere},
                                NamedKind{"bit", InjectionKind::bit},
                                NamedKind{"coefficient", InjectionKind::coefficient},
                                NamedKind{"ulp", InjectionKind::ulp},
                                NamedKind{"exponentiation", InjectionKind::exponentiation},
                                NamedKind{"transfer", InjectionKind::transfer}};

float nextUp(float value) {
  return std::nextafter(value, std::numeric_limits<float>::infinity());
}

}  // namespace

InjectionKind injectionKind(const std::string& name) {
  for (const NamedKind& named : namedKinds)
    if (name == named.name) return named.kind;
  throw InputError("unknown fault '" + name +
                   "': use sphere, bit, coefficient, ulp, exponentiation or transfer");
}

std::string nameOf(InjectionKind kind) {
  for (const NamedKind& named : namedKinds)
    if (kind == named.kind) return named.name;
  return {};
}

FaultyEngine::FaultyEngine(std::unique_ptr<Engine> engine, InjectionKind kind)
    : ForwardingEngine(std::move(engine)), kind_(kind) {}

/// Another place with every call.
std::size_t FaultyEngine::choose(std::size_t count) {
  return ++calls_ * 2654435761u % count;
}

std::vector<Sphere> FaultyEngine::moveSpheres(std::span<const glm::vec4> positions) {
  auto spheres = engine_->moveSpheres(positions);
  if (kind_ != InjectionKind::sphere || spheres.empty()) return spheres;
  const std::size_t sample = choose(spheres.size());
  const int number = int(choose(4));
  float& value = number < 3 ? spheres[sample].center[number] : spheres[sample].radius;
  value = nextUp(value);
  faults_.push_back({caseName_, sample, movedSpherePlace(sample, number)});
  return spheres;
}

std::vector<BitCube> FaultyEngine::mergeBitCubes(std::span<const Sphere> spheres,
                                                 ReceiverSpan receivers) {
  auto cubes = engine_->mergeBitCubes(spheres, receivers);
  if (kind_ != InjectionKind::bit || cubes.empty()) return cubes;
  const std::size_t sample = choose(cubes.size());
  const int word = int(choose(bitCubeRows)), column = int(choose(faceSize));
  cubes[sample].rows[word] ^= 1u << column;
  faults_.push_back({caseName_, sample, bitPlace(word, column)});
  return cubes;
}

std::vector<OcclusionHaar> FaultyEngine::transformOcclusion(std::span<const BitCube> cubes) {
  auto occlusion = engine_->transformOcclusion(cubes);
  if (kind_ != InjectionKind::coefficient || occlusion.empty()) return occlusion;
  const std::size_t sample = choose(occlusion.size());
  auto& coefficients = occlusion[sample].coefficients;
  const std::size_t index = choose(coefficients.size());
  coefficients[index] = nextUp(coefficients[index]);
  faults_.push_back({caseName_, sample, coefficientPlace(int(index))});
  return occlusion;
}

void FaultyEngine::moveByOneUlp(std::vector<glm::vec4>& radiance) {
  const std::size_t sample = choose(radiance.size());
  const int channel = int(choose(3));
  radiance[sample][channel] = nextUp(radiance[sample][channel]);
  faults_.push_back({caseName_, sample, channelPlace(channel)});
}

std::vector<glm::vec4> FaultyEngine::tripleProduct(std::span<const OcclusionHaar> occlusion,
                                                   std::span<const LobeBlend> lobes) {
  auto radiance = engine_->tripleProduct(occlusion, lobes);
  if (radiance.empty()) return radiance;
  if (kind_ == InjectionKind::ulp) moveByOneUlp(radiance);
  return radiance;
}

std::vector<glm::vec4> FaultyEngine::shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                           StageTimes* times) {
  return engine_->shade(spheres, receivers, times);
}

std::vector<glm::vec4> FaultyEngine::shadeByExponentiation(std::span<const Sphere> spheres,
                                                           ReceiverSpan receivers,
                                                           StageTimes* times) {
  auto radiance = engine_->shadeByExponentiation(spheres, receivers, times);
  if (kind_ == InjectionKind::exponentiation && !radiance.empty()) moveByOneUlp(radiance);
  return radiance;
}

std::vector<glm::vec4> FaultyEngine::shadeByTransfer(const TransferReceivers& receivers,
                                                     StageTimes* times) {
  auto radiance = engine_->shadeByTransfer(receivers, times);
  if (kind_ == InjectionKind::transfer && !radiance.empty()) moveByOneUlp(radiance);
  return radiance;
}

}  // namespace haarlight::verify
