#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "render/radiance_method.h"

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
std::vector<double> lobeImportance(std::span<const SurfaceSample> samples, bool anyNormal) {
  auto importance = countLobes(receiversOf(samples).lobes);
  if (anyNormal)
    for (double& lobe : importance) lobe += 1e-9;
  return importance;
}

class HaarMethod final : public RadianceMethod {
 public:
  HaarMethod(const Scene& scene, std::shared_ptr<Engine> engine, const ShadingSettings& settings,
             std::vector<double> lobeImportance)
      : scene_(scene),
        engine_(std::move(engine)),
        settings_(settings),
        lobeImportance_(std::move(lobeImportance)) {
    sceneChanged(true);
  }

  std::string name() const override { return "haar"; }
  std::string deviceName() const override { return engine_->name() + ": " + engine_->deviceName(); }

  void sceneChanged(bool lightToo) override {
    spheres_ = scene_.blockerSpheres();
    if (lightToo)
      engine_->setShading(
          buildShadingTables(scene_.light.projection.cube, settings_, lobeImportance_));
  }

  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    const auto white = engine_->shade(spheres_, receiversOf(samples), &times_);
    std::vector<glm::vec3> radiance;
    radiance.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      radiance.push_back(samples[i].albedo * glm::vec3(white[i]));
    return radiance;
  }

 private:
  const Scene& scene_;
  std::shared_ptr<Engine> engine_;
  ShadingSettings settings_;
  std::vector<double> lobeImportance_;
  std::vector<Sphere> spheres_;
};

}  // namespace

std::unique_ptr<RadianceMethod> makeHaarMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                                               const ShadingSettings& settings,
                                               std::span<const SurfaceSample> typicalSamples,
                                               bool anyNormal) {
  return std::make_unique<HaarMethod>(scene, std::move(engine), settings,
                                      lobeImportance(typicalSamples, anyNormal));
}

}  // namespace haarlight
