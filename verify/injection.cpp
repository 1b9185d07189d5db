#include "verify/injection.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "engine/reference/sample_shader.h"
#include "verify/places.h"

namespace haarlight::verify {

namespace {

struct NamedKind {
  const char* name;
  InjectionKind kind;
};
constexpr std::array namedKinds{
    NamedKind{"sphere", InjectionKind::sphere}, NamedKind{"bit", InjectionKind::bit},
    NamedKind{"coefficient", InjectionKind::coefficient}, NamedKind{"ulp", InjectionKind::ulp},
    NamedKind{"order", InjectionKind::order}};

float nextUp(float value) {
  return std::nextafter(value, std::numeric_limits<float>::infinity());
}

/// One sum, term after term, instead of 32.
class SequentialSum {
 public:
  void add(std::size_t, const glm::vec4& coefficient, float value) {
    for (int channel = 0; channel < 3; ++channel)
      sum_[channel] = std::fma(coefficient[channel], value, sum_[channel]);
  }
  glm::vec3 total() const { return sum_; }

 private:
  glm::vec3 sum_{0};
};

}  // namespace

InjectionKind injectionKind(const std::string& name) {
  for (const NamedKind& named : namedKinds)
    if (name == named.name) return named.kind;
  throw InputError("unknown fault '" + name + "': use sphere, bit, coefficient, ulp or order");
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

void FaultyEngine::setShading(const ShadingTables& tables) {
  tables_ = tables;
  engine_->setShading(tables);
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

/// The first sample, from a chosen one on, whose sum another order changes.
void FaultyEngine::reorder(std::vector<glm::vec4>& radiance,
                           std::span<const OcclusionHaar> occlusion,
                           std::span<const LobeBlend> lobes) {
  const std::size_t first = choose(radiance.size());
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const std::size_t sample = (first + i) % radiance.size();
    const glm::vec4 right = radiance[sample];
    const glm::vec4 other =
        SampleShader<SequentialSum>(tables_, occlusion[sample], lobes[sample]).radiance();
    for (int channel = 0; channel < 3; ++channel)
      if (other[channel] != right[channel])
        faults_.push_back({caseName_, sample, channelPlace(channel)});
    if (other == right) continue;
    radiance[sample] = other;
    return;
  }
}

std::vector<glm::vec4> FaultyEngine::tripleProduct(std::span<const OcclusionHaar> occlusion,
                                                   std::span<const LobeBlend> lobes) {
  auto radiance = engine_->tripleProduct(occlusion, lobes);
  if (radiance.empty()) return radiance;
  if (kind_ == InjectionKind::ulp) moveByOneUlp(radiance);
  if (kind_ == InjectionKind::order) reorder(radiance, occlusion, lobes);
  return radiance;
}

std::vector<glm::vec4> FaultyEngine::shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                                           StageTimes* times) {
  return engine_->shade(spheres, receivers, times);
}

}  // namespace haarlight::verify
