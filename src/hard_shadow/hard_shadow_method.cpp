#include "hard_shadow/hard_shadow_method.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"
#include "hard_shadow/classic_shadows.h"
#include "hard_shadow/exact_shadows.h"

namespace haarlight {

namespace {

using Json = nlohmann::ordered_json;

Json byDepth(const OctreeCounts::ByDepth& counts) {
  std::size_t used = counts.size();
  while (used > 0 && counts[used - 1] == 0) --used;
  return std::vector<std::uint64_t>(counts.begin(), counts.begin() + std::ptrdiff_t(used));
}

Json figuresOf(const ShadowPairs& pairs) {
  return {{"tested", pairs.tested},
          {"dropped", pairs.dropped},
          {"excluded", pairs.excluded},
          {"kept", pairs.kept.size()}};
}

Json figuresOf(const OctreeCounts& counts) {
  return {{"cells_by_depth", byDepth(counts.cells)},
          {"unreached_by_depth", byDepth(counts.unreached)},
          {"leaves_in_shadow_by_depth", byDepth(counts.inShadow)},
          {"leaves_in_light_by_depth", byDepth(counts.inLight)},
          {"leaves_by_ray", counts.byRay},
          {"rays", counts.rays},
          {"proof_seconds", counts.proofSeconds},
          {"ray_seconds", counts.raySeconds},
          {"sort_seconds", counts.sortSeconds}};
}

/// One of Shadows for each light, and the seconds that making and asking them took.
template <typename Shadows>
class MethodWithLights : public HardShadowMethod {
 public:
  void answer(std::size_t light, const SurfaceView& view,
              std::span<std::uint8_t> inShadow) override {
    const Stopwatch watch;
    ask(*shadows_[light], view, inShadow);
    answerSeconds_ += watch.total();
  }

 protected:
  /// `make` gives the pointer to those of a light.
  template <typename Make>
  MethodWithLights(std::span<const ShadowLight> lights, const Make& make) {
    const Stopwatch watch;
    for (const ShadowLight& light : lights) shadows_.push_back(make(light));
    prepareSeconds_ = watch.total();
  }

  virtual void ask(const Shadows& shadows, const SurfaceView& view,
                   std::span<std::uint8_t> inShadow) = 0;

  /// `perPicture` is the name of what is done for every picture.
  Json secondsFigures(const char* perPicture) const {
    return {{"total", prepareSeconds_ + answerSeconds_},
            {"prepare", prepareSeconds_},
            {perPicture, answerSeconds_}};
  }

  std::vector<std::unique_ptr<Shadows>> shadows_;

 private:
  double prepareSeconds_ = 0, answerSeconds_ = 0;
};

class OctreeMethod final : public MethodWithLights<SceneOctrees> {
 public:
  OctreeMethod(std::span<const ShadowParticipant> participants, std::span<const ShadowLight> lights,
               const LevelOfDetail& detail)
      : MethodWithLights(lights, [&](const ShadowLight& light) {
          auto octrees = std::make_unique<SceneOctrees>(detail);
          octrees->show(participants, light);
          return octrees;
        }) {}

  std::string name() const override { return "octree"; }
  const SceneOctrees* octreesOf(std::size_t light) const override { return shadows_[light].get(); }

  Json figures() const override {
    Json lights = Json::array(), seconds = secondsFigures("look_up");
    double pairs = 0, octrees = 0, cellEdge = 0;
    std::size_t memory = 0, leaves = 0;
    for (const auto& shadows : shadows_) {
      const SceneOctreeWork& work = shadows->work();
      lights.push_back({{"pairs", figuresOf(work.pairs)}, {"octrees", figuresOf(work.counts)}});
      pairs += work.pairSeconds, octrees += work.octreeSeconds;
      memory += shadows->memory();
      cellEdge = std::max(cellEdge, shadows->cellEdge());
      for (const ShadowOctree& octree : shadows->octrees()) leaves += octree.leaves().size();
    }
    seconds["pairs"] = pairs;
    seconds["octrees"] = octrees;
    seconds["prepare"] = seconds["prepare"].get<double>() - pairs - octrees;
    return {{"cell_edge", cellEdge},
            {"leaves", leaves},
            {"bytes", memory},
            {"seconds", seconds},
            {"light", lights}};
  }

 private:
  void ask(const SceneOctrees& octrees, const SurfaceView& view,
           std::span<std::uint8_t> inShadow) override {
    octrees.answer(view.points, inShadow);
  }
};

class ClassicMethod final : public MethodWithLights<ClassicShadows> {
 public:
  ClassicMethod(std::span<const ShadowParticipant> participants,
                std::span<const ShadowLight> lights, ClassicVolume::Sides sides)
      : MethodWithLights(lights,
                         [&](const ShadowLight& light) {
                           return std::make_unique<ClassicShadows>(participants, light, sides);
                         }),
        sides_(sides) {}

  std::string name() const override {
    return sides_ == ClassicVolume::Sides::ofSilhouette ? "classic" : "classic-triangles";
  }

  Json figures() const override {
    std::size_t faces = 0, memory = 0;
    for (const auto& shadows : shadows_) faces += shadows->faceCount(), memory += shadows->memory();
    return {{"faces", faces}, {"bytes", memory}, {"seconds", secondsFigures("draw")}};
  }

 private:
  void ask(const ClassicShadows& volumes, const SurfaceView& view,
           std::span<std::uint8_t> inShadow) override {
    volumes.answer(view, inShadow);
  }

  ClassicVolume::Sides sides_;
};

class ExactMethod final : public MethodWithLights<ExactShadows> {
 public:
  ExactMethod(std::span<const ShadowParticipant> participants, std::span<const ShadowLight> lights)
      : MethodWithLights(lights, [&](const ShadowLight& light) {
          return std::make_unique<ExactShadows>(participants, light);
        }) {}

  std::string name() const override { return "exact"; }

  Json figures() const override { return {{"rays", rays_}, {"seconds", secondsFigures("cast")}}; }

 private:
  void ask(const ExactShadows& shadows, const SurfaceView& view,
           std::span<std::uint8_t> inShadow) override {
    rays_ += shadows.answer(view.points, inShadow);
  }

  std::uint64_t rays_ = 0;
};

}  // namespace

std::unique_ptr<HardShadowMethod> makeOctreeShadows(std::span<const ShadowParticipant> participants,
                                                    std::span<const ShadowLight> lights,
                                                    const LevelOfDetail& detail) {
  return std::make_unique<OctreeMethod>(participants, lights, detail);
}

std::unique_ptr<HardShadowMethod> makeClassicShadows(
    std::span<const ShadowParticipant> participants, std::span<const ShadowLight> lights,
    ClassicVolume::Sides sides) {
  return std::make_unique<ClassicMethod>(participants, lights, sides);
}

std::unique_ptr<HardShadowMethod> makeExactShadows(std::span<const ShadowParticipant> participants,
                                                   std::span<const ShadowLight> lights) {
  return std::make_unique<ExactMethod>(participants, lights);
}

}  // namespace haarlight
