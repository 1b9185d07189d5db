#include <glm/geometric.hpp>

#include "render/radiance_method.h"

namespace haarlight {

namespace {

Receivers receiversOf(std::span<const SurfaceSample> samples) {
  Receivers receivers;
  for (const SurfaceSample& sample : samples) receivers.add(sample.position, sample.normal);
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
  HaarMethod(const Scene& scene, std::shared_ptr<Engine> engine, const ShadingTables& tables)
      : engine_(std::move(engine)), spheres_(scene.blockerSpheres()) {
    engine_->setShading(tables);
  }

  std::string name() const override { return "haar"; }
  std::string deviceName() const override { return engine_->name() + ": " + engine_->deviceName(); }

  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    const auto white = engine_->shade(spheres_, receiversOf(samples), &times_);
    std::vector<glm::vec3> radiance;
    radiance.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      radiance.push_back(samples[i].albedo * glm::vec3(white[i]));
    return radiance;
  }

 private:
  std::shared_ptr<Engine> engine_;
  std::vector<Sphere> spheres_;
};

}  // namespace

std::unique_ptr<RadianceMethod> makeHaarMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                                               const ShadingSettings& settings,
                                               std::span<const SurfaceSample> typicalSamples,
                                               bool anyNormal) {
  const auto importance = lobeImportance(typicalSamples, anyNormal);
  const ShadingTables tables =
      buildShadingTables(scene.light.projection.cube, settings, importance);
  return std::make_unique<HaarMethod>(scene, std::move(engine), tables);
}

}  // namespace haarlight
