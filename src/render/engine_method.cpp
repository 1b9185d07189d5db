#include "render/engine_method.h"

#include "base/parallel.h"

namespace haarlight {

namespace {

Receivers receiversOf(std::span<const SurfaceSample> samples) {
  Receivers receivers;
  receivers.resize(samples.size());
  parallelFor(samples.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      receivers.set(i, samples[i].position, samples[i].normal);
  });
  return receivers;
}

/// Importance of the lobes; a lobe that has not occurred so far, but may, counts next to nothing.
std::vector<double> importanceOfLobes(std::span<const SurfaceSample> samples, bool anyNormal) {
  auto importance = countLobes(receiversOf(samples).lobes);
  if (anyNormal)
    for (double& lobe : importance) lobe += 1e-9;
  return importance;
}

}  // namespace

EngineMethod::EngineMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                           std::span<const SurfaceSample> typicalSamples, bool anyNormal)
    : scene_(scene),
      engine_(std::move(engine)),
      lobeImportance_(importanceOfLobes(typicalSamples, anyNormal)) {}

std::string EngineMethod::deviceName() const {
  return engine_->name() + ": " + engine_->deviceName();
}

void EngineMethod::sceneChanged(bool lightToo) {
  spheres_ = scene_.blockerSpheres();
  if (lightToo) setLight(scene_.light.projection.cube, lobeImportance_);
}

std::vector<glm::vec3> EngineMethod::radiance(std::span<const SurfaceSample> samples) {
  const auto white = shade(spheres_, receiversOf(samples));
  std::vector<glm::vec3> radiance;
  radiance.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    radiance.push_back(samples[i].albedo * glm::vec3(white[i]));
  return radiance;
}

}  // namespace haarlight
