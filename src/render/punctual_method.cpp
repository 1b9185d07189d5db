#include "render/punctual_method.h"

#include <algorithm>
#include <numbers>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "hard_shadow/exact_shadows.h"
#include "hard_shadow/scene_octrees.h"
#include "mesh_shadow/lit_mesh.h"
#include "render/scene_participants.h"

namespace haarlight {

namespace {

/// Shadows of one light, which follow the scene.
class LightShadows {
 public:
  virtual ~LightShadows() = default;
  virtual void show(std::span<const ShadowParticipant> participants, const ShadowLight& light,
                    const std::vector<bool>& moved) = 0;
  virtual void answer(std::span<const ReceiverPoint> points,
                      std::span<std::uint8_t> inShadow) const = 0;
  /// By the last call of show.
  virtual std::size_t builtOctrees() const { return 0; }
};

class OctreeLightShadows final : public LightShadows {
 public:
  explicit OctreeLightShadows(const LevelOfDetail& detail) : octrees_(detail) {}

  void show(std::span<const ShadowParticipant> participants, const ShadowLight& light,
            const std::vector<bool>& moved) override {
    octrees_.show(participants, light, moved);
  }
  void answer(std::span<const ReceiverPoint> points,
              std::span<std::uint8_t> inShadow) const override {
    octrees_.answer(points, inShadow);
  }
  std::size_t builtOctrees() const override { return octrees_.work().builtOctrees; }

 private:
  SceneOctrees octrees_;
};

class ExactLightShadows final : public LightShadows {
 public:
  void show(std::span<const ShadowParticipant> participants, const ShadowLight& light,
            const std::vector<bool>&) override {
    shadows_.emplace(participants, light);
  }
  void answer(std::span<const ReceiverPoint> points,
              std::span<std::uint8_t> inShadow) const override {
    shadows_->answer(points, inShadow);
  }

 private:
  std::optional<ExactShadows> shadows_;
};

using MakeShadows = std::function<std::unique_ptr<LightShadows>()>;

class PunctualMethod final : public RadianceMethod {
 public:
  PunctualMethod(std::unique_ptr<RadianceMethod> method, const Scene& scene,
                 MakeShadows makeShadows)
      : method_(std::move(method)),
        scene_(scene),
        participants_(scene),
        makeShadows_(std::move(makeShadows)) {
    showShadows();
  }

  std::string name() const override { return method_->name(); }
  std::string deviceName() const override { return method_->deviceName(); }
  bool readsLightCube() const override { return method_->readsLightCube(); }
  void newFrame() override { method_->newFrame(); }

  void sceneChanged(bool lightToo) override {
    method_->sceneChanged(lightToo);
    showShadows();
  }

  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    std::vector<glm::vec3> result = method_->radiance(samples);
    const Stopwatch watch;
    const std::vector<ReceiverPoint> points = pointsOf(samples);
    std::vector<std::uint8_t> inShadow(samples.size());
    for (std::size_t light = 0; light < shadows_.size(); ++light) {
      shadows_[light]->answer(points, inShadow);
      addLight(scene_.punctualLights[light], samples, points, inShadow, result);
    }
    punctualSeconds_ += watch.total();
    noteTimes();
    return result;
  }

 private:
  void showShadows();
  std::vector<ReceiverPoint> pointsOf(std::span<const SurfaceSample> samples) const;
  ReceiverPoint pointOf(const SurfaceSample& sample) const;
  void addLight(const PunctualLight& light, std::span<const SurfaceSample> samples,
                std::span<const ReceiverPoint> points, std::span<const std::uint8_t> inShadow,
                std::span<glm::vec3> result) const;
  void noteTimes() {
    times_ = method_->times();
    times_.total += punctualSeconds_;
  }

  std::unique_ptr<RadianceMethod> method_;
  const Scene& scene_;
  SceneParticipants participants_;
  MakeShadows makeShadows_;
  std::vector<std::unique_ptr<LightShadows>> shadows_;  ///< by light
  std::vector<std::uint64_t> revisions_;                ///< of the objects, as last shown
};

void PunctualMethod::showShadows() {
  const Stopwatch watch;
  while (shadows_.size() < scene_.punctualLights.size()) shadows_.push_back(makeShadows_());
  std::vector<bool> moved(participants_.participants().size(), false);
  revisions_.resize(scene_.objects.size(), ~std::uint64_t(0));
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    moved[i] = revisions_[i] != scene_.objects[i].revision;
    revisions_[i] = scene_.objects[i].revision;
  }
  for (std::size_t light = 0; light < shadows_.size(); ++light) {
    shadows_[light]->show(participants_.participants(), scene_.punctualLights[light].light, moved);
    builtShadowOctrees_ += shadows_[light]->builtOctrees();
  }
  punctualSeconds_ += watch.total();
  noteTimes();
}

/// On a triangle by its corners, which single precision does not take off its plane.
ReceiverPoint PunctualMethod::pointOf(const SurfaceSample& sample) const {
  const MeshPoint& place = sample.point;
  const bool onReceiver = place.object == MeshPoint::onReceiver;
  ReceiverPoint point{onReceiver ? std::uint32_t(scene_.objects.size()) : place.object,
                      glm::dvec3(sample.position), glm::dvec3(sample.geometricNormal)};
  if (onReceiver) return point;
  if (scene_.objects[place.object].solid) {
    point.fromWithin = place.fromBehind;
    return point;
  }
  const auto& corners = scene_.objects[place.object].mesh.positions;
  point.position = glm::dvec3(0);
  for (int i = 0; i < 3; ++i)
    point.position += double(place.weights[i]) * glm::dvec3(corners[place.vertices[i]]);
  return point;
}

std::vector<ReceiverPoint> PunctualMethod::pointsOf(std::span<const SurfaceSample> samples) const {
  std::vector<ReceiverPoint> points(samples.size());
  parallelFor(samples.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) points[i] = pointOf(samples[i]);
  });
  return points;
}

void PunctualMethod::addLight(const PunctualLight& light, std::span<const SurfaceSample> samples,
                              std::span<const ReceiverPoint> points,
                              std::span<const std::uint8_t> inShadow,
                              std::span<glm::vec3> result) const {
  parallelFor(samples.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (inShadow[i]) continue;
      const glm::dvec3 irradiance =
          irradianceOf(light, points[i].position, glm::dvec3(samples[i].normal));
      result[i] += glm::vec3(glm::dvec3(samples[i].albedo) * irradiance / std::numbers::pi);
    }
  });
}

std::unique_ptr<RadianceMethod> decorated(std::unique_ptr<RadianceMethod> method,
                                          const Scene& scene, MakeShadows makeShadows) {
  return std::make_unique<PunctualMethod>(std::move(method), scene, std::move(makeShadows));
}

}  // namespace

std::unique_ptr<RadianceMethod> withPunctualLights(std::unique_ptr<RadianceMethod> method,
                                                   const Scene& scene,
                                                   const LevelOfDetail& detail) {
  if (scene.punctualLights.empty()) return method;
  return decorated(std::move(method), scene,
                   [detail] { return std::make_unique<OctreeLightShadows>(detail); });
}

std::unique_ptr<RadianceMethod> withExactPunctualLights(std::unique_ptr<RadianceMethod> method,
                                                        const Scene& scene) {
  if (scene.punctualLights.empty()) return method;
  return decorated(std::move(method), scene, [] { return std::make_unique<ExactLightShadows>(); });
}

}  // namespace haarlight
