#include "benchmark/peers.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "base/text_format.h"
#include "benchmark/double_product.h"
#include "engine/stage_times.h"
#include "image/compare.h"
#include "render/radiance_method.h"

namespace haarlight::benchmark {

namespace {

using Radiance = std::vector<glm::vec3>;

constexpr std::size_t fewFrames = 3;
constexpr double slowSeconds = 0.1;
constexpr std::size_t samplesPerTask = 256;
constexpr ShadingSettings shading{.terms = 200, .levels = 2};

Radiance withoutAlpha(const std::vector<glm::vec4>& radiance) {
  return Radiance(radiance.begin(), radiance.end());
}

class PeerMeasurement {
 public:
  PeerMeasurement(const Inputs& inputs, const FittedScene& scene, const OpenSubject& staged,
                  const Effort& effort)
      : inputs_(inputs),
        scene_(scene.scene),
        staged_(staged),
        effort_(effort),
        spheres_(scene_.blockerSpheres()) {
    comparison_.spheres = scene.spheres;
    comparison_.threads = threadCount();
    comparison_.stagedSubject = staged.subject.name();
  }

  std::optional<PeerComparison> run(std::span<const OpenSubject> subjects,
                                    std::span<const Row> rows);

 private:
  template <typename Frame>
  Radiance add(const std::string& name, const std::string& description, const Frame& frame,
               double deviceSeconds = 0);
  Radiance addMethod(const std::string& name, const std::string& description,
                     RadianceMethod& method);
  void addReference();
  void addStaticLight();
  void addRows(std::span<const OpenSubject> subjects, std::span<const Row> rows);
  StageTimes deviceStages() const;
  Errors errorsOf(const Radiance& radiance) const;

  const Inputs& inputs_;
  const Scene& scene_;
  const OpenSubject& staged_;
  const Effort& effort_;
  std::vector<Sphere> spheres_;
  Radiance meshReference_, sphereReference_;
  PeerComparison comparison_;
  std::vector<Radiance> pictures_;  ///< of the peers
};

/// Measures `frame` and keeps its picture, which is also returned; nothing after an interruption.
template <typename Frame>
Radiance PeerMeasurement::add(const std::string& name, const std::string& description,
                              const Frame& frame, double deviceSeconds) {
  if (effort_.interrupted()) return {};
  if (effort_.progress) effort_.progress("measuring peers: " + name, 0);
  Stopwatch watch;
  const Radiance picture = frame();
  const bool isSlow = watch.lap() > slowSeconds;
  std::vector<double> seconds;
  const std::size_t frames = isSlow ? std::min(fewFrames, effort_.frames) : effort_.frames;
  while (seconds.size() < frames && (seconds.empty() || !effort_.interrupted())) {
    watch.lap();
    frame();
    seconds.push_back(watch.lap() + deviceSeconds);
  }
  comparison_.peers.push_back({name, description, quartilesOf(seconds), deviceSeconds, {}});
  return pictures_.emplace_back(picture);
}

Radiance PeerMeasurement::addMethod(const std::string& name, const std::string& description,
                                    RadianceMethod& method) {
  return add(name, description, [&] { return method.radiance(inputs_.samples); });
}

/// Every thread has engines of its own, as verification has them.
void PeerMeasurement::addReference() {
  const auto tables =
      buildShadingTables(inputs_.light(), shading, countLobes(inputs_.receivers.lobes));
  add("reference, C++ on all threads", "the scalar engine, 200 terms, level 2", [&] {
    Radiance radiance(inputs_.receivers.size());
    parallelFor(radiance.size(), samplesPerTask, [&](std::size_t begin, std::size_t end) {
      const auto engine = makeReferenceEngine(nullptr);
      engine->setShading(tables);
      const auto part =
          engine->shade(spheres_, ReceiverSpan(inputs_.receivers).part(begin, end - begin));
      std::ranges::copy(withoutAlpha(part), radiance.begin() + std::ptrdiff_t(begin));
    });
    return radiance;
  });
}

/// What merging and transform take on the device.
StageTimes PeerMeasurement::deviceStages() const {
  staged_.engine->setShading(
      buildShadingTables(inputs_.light(), shading, countLobes(inputs_.receivers.lobes)));
  staged_.engine->shade(spheres_, inputs_.receivers);
  std::vector<StageTimes> frames(std::max(fewFrames, effort_.frames));
  for (StageTimes& times : frames) staged_.engine->shade(spheres_, inputs_.receivers, &times);
  return stageMedians(frames);
}

void PeerMeasurement::addStaticLight() {
  if (effort_.interrupted()) return;
  const StageTimes stages = deviceStages();
  const auto& lobes = inputs_.receivers.lobes;
  const auto cubes = staged_.engine->mergeBitCubes(spheres_, inputs_.receivers);
  const TexelProduct texels(inputs_.light(), lobes);
  add(
      "static light, all texels",
      "light times lobe made beforehand; the device's merging, then a sum over blocked texels",
      [&] { return texels.radiance(cubes, lobes); }, stages.merge);
  const auto occlusion = staged_.engine->transformOcclusion(cubes);
  for (const int terms : {maximumTerms, shading.terms, 50}) {
    const HaarProduct product(inputs_.light(), lobes, terms);
    add(
        "double product; " + countText(std::uint64_t(terms), "term"),
        "light times lobe made beforehand; the device's merging and transform, then a dot product",
        [&] { return product.radiance(occlusion, lobes); }, stages.merge + stages.transform);
  }
}

Errors PeerMeasurement::errorsOf(const Radiance& radiance) const {
  return {relativeError(radiance, meshReference_), relativeError(radiance, sphereReference_)};
}

void PeerMeasurement::addRows(std::span<const OpenSubject> subjects, std::span<const Row> rows) {
  for (std::size_t i = 0; i < rows.size() && !effort_.interrupted(); ++i) {
    const Setting& at = rows[i].setting;
    if (at.spheres != comparison_.spheres) continue;
    Engine& engine = *subjects[rows[i].subject].engine;
    engine.setShading(buildShadingTables(inputs_.light(), {.terms = at.terms, .levels = at.levels},
                                         countLobes(inputs_.receivers.lobes)));
    const auto radiance = engine.shade(spheres_, inputs_.receivers);
    comparison_.rowErrors.push_back({i, errorsOf(withoutAlpha(radiance))});
  }
}

std::optional<PeerComparison> PeerMeasurement::run(std::span<const OpenSubject> subjects,
                                                   std::span<const Row> rows) {
  meshReference_ = addMethod(embreePeer, "rays to every texel above the horizon, packets of 16",
                             *makePixelMeshMethod(scene_));
  sphereReference_ = addMethod("pixel basis, spheres", "all texels, blocked exactly by the spheres",
                               *makePixelMethod(scene_, nullptr));
  if (meshReference_.empty() || sphereReference_.empty()) return std::nullopt;
  addMethod("pixel basis, Embree on the spheres",
            "rays to every texel above the horizon, packets of 16", *makePixelRayMethod(scene_));
  addReference();
  addStaticLight();
  for (std::size_t i = 0; i < pictures_.size(); ++i)
    comparison_.peers[i].errors = errorsOf(pictures_[i]);
  addRows(subjects, rows);
  return comparison_;
}

}  // namespace

std::optional<PeerComparison> measurePeers(std::span<const OpenSubject> subjects,
                                           std::span<const Row> rows, const Inputs& inputs,
                                           const FittedScene& scene, const OpenSubject& staged,
                                           const Effort& effort) {
  return PeerMeasurement(inputs, scene, staged, effort).run(subjects, rows);
}

double relativeError(std::span<const glm::vec3> radiance, std::span<const glm::vec3> reference) {
  const auto asImage = [](std::span<const glm::vec3> values) {
    Image image(int(values.size()), 1);
    std::ranges::copy(values, image.pixels.begin());
    return image;
  };
  return compareImages(asImage(radiance), asImage(reference)).relativeRootMeanSquare;
}

}  // namespace haarlight::benchmark
