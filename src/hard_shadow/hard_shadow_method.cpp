#include "hard_shadow/hard_shadow_method.h"

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
          {"rays", counts.rays}};
}

/// One of Shadows for each light, and the seconds that making and asking them took.
template <typename Shadows>
class MethodWithLights : public HardShadowMethod {
 public:
  void answer(std::size_t light, const SurfaceView& view,
              std::span<std::uint8_t> inShadow) override {
    Stopwatch watch;
    answerFor(light, view, inShadow);
    answerSeconds_ += watch.lap();
  }

 protected:
  virtual void answerFor(std::size_t light, const SurfaceView& view,
                         std::span<std::uint8_t> inShadow) = 0;

  std::vector<std::unique_ptr<Shadows>> shadows_;
  double prepareSeconds_ = 0, answerSeconds_ = 0;
};

class OctreeMethod final : public MethodWithLights<SceneOctrees> {
 public:
  OctreeMethod(std::span<const ShadowParticipant> participants, std::span<const ShadowLight> lights,
               const LevelOfDetail& detail) {
    for (const ShadowLight& light : lights) {
      shadows_.push_back(std::make_unique<SceneOctrees>(detail));
      shadows_.back()->show(participants, light);
    }
  }

  std::string name() const override { return "octree"; }
  const SceneOctrees* octreesOf(std::size_t light) const override { return shadows_[light].get(); }

  Json figures() const override {
    Json lights = Json::array();
    double prepare = 0, pairs = 0, octrees = 0;
    std::size_t memory = 0, leaves = 0;
    for (const auto& shadows : shadows_) {
      const SceneOctreeWork& work = shadows->work();
      lights.push_back({{"pairs", figuresOf(work.pairs)}, {"octrees", figuresOf(work.counts)}});
      prepare += work.prepareSeconds, pairs += work.pairSeconds, octrees += work.octreeSeconds;
      memory += shadows->memory();
      for (const ShadowOctree& octree : shadows->octrees()) leaves += octree.leaves().size();
    }
    const double total = prepare + pairs + octrees + answerSeconds_;
    return {{"leaves", leaves},
            {"bytes", memory},
            {"seconds",
             {{"total", total},
              {"prepare", prepare},
              {"pairs", pairs},
              {"octrees", octrees},
              {"look_up", answerSeconds_}}},
            {"light", lights}};
  }

 private:
  void answerFor(std::size_t light, const SurfaceView& view,
                 std::span<std::uint8_t> inShadow) override {
    shadows_[light]->answer(view.points, inShadow);
  }
};

class ClassicMethod final : public MethodWithLights<ClassicShadows> {
 public:
  ClassicMethod(std::span<const ShadowParticipant> participants,
                std::span<const ShadowLight> lights) {
    const Stopwatch watch;
    for (const ShadowLight& light : lights)
      shadows_.push_back(std::make_unique<ClassicShadows>(participants, light));
    prepareSeconds_ = watch.total();
  }

  std::string name() const override { return "classic"; }

  Json figures() const override {
    std::size_t faces = 0, memory = 0;
    for (const auto& shadows : shadows_) faces += shadows->faceCount(), memory += shadows->memory();
    return {{"faces", faces},
            {"bytes", memory},
            {"seconds",
             {{"total", prepareSeconds_ + answerSeconds_},
              {"prepare", prepareSeconds_},
              {"draw", answerSeconds_}}}};
  }

 private:
  void answerFor(std::size_t light, const SurfaceView& view,
                 std::span<std::uint8_t> inShadow) override {
    shadows_[light]->answer(view, inShadow);
  }
};

class ExactMethod final : public MethodWithLights<ExactShadows> {
 public:
  ExactMethod(std::span<const ShadowParticipant> participants,
              std::span<const ShadowLight> lights) {
    const Stopwatch watch;
    for (const ShadowLight& light : lights)
      shadows_.push_back(std::make_unique<ExactShadows>(participants, light));
    prepareSeconds_ = watch.total();
  }

  std::string name() const override { return "exact"; }

  Json figures() const override {
    return {{"rays", rays_},
            {"seconds",
             {{"total", prepareSeconds_ + answerSeconds_},
              {"prepare", prepareSeconds_},
              {"cast", answerSeconds_}}}};
  }

 private:
  void answerFor(std::size_t light, const SurfaceView& view,
                 std::span<std::uint8_t> inShadow) override {
    rays_ += shadows_[light]->answer(view.points, inShadow);
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
    std::span<const ShadowParticipant> participants, std::span<const ShadowLight> lights) {
  return std::make_unique<ClassicMethod>(participants, lights);
}

std::unique_ptr<HardShadowMethod> makeExactShadows(std::span<const ShadowParticipant> participants,
                                                   std::span<const ShadowLight> lights) {
  return std::make_unique<ExactMethod>(participants, lights);
}

}  // namespace haarlight
