#include "base/parallel.h"
#include "base/stopwatch.h"
#include "render/light_coefficients.h"
#include "render/radiance_method.h"
#include "render/receiver_grid.h"

namespace haarlight {

namespace {

constexpr std::size_t samplesPerTask = 4096;

class TransferMethod final : public RadianceMethod {
 public:
  TransferMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                 std::shared_ptr<const SceneTransfer> transfer, ShadedPer per)
      : scene_(scene),
        engine_(std::move(engine)),
        transfer_(std::move(transfer)),
        per_(per),
        coefficients_(transfer_->rows.order) {
    engine_->setTransferRows(transfer_->rows);
    sceneChanged(true);
  }

  std::string name() const override { return "sh"; }
  std::string deviceName() const override { return engine_->name() + ": " + engine_->deviceName(); }

  void sceneChanged(bool lightToo) override {
    if (!lightToo) return;
    const TransferLights lights = coefficients_.of(scene_.light);
    lightCount_ = lights.count();
    engine_->setTransferLights(lights);
    newFrame();
  }

  bool readsLightCube() const override { return false; }

  void newFrame() override { ofVertices_.clear(); }

  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    if (per_ == ShadedPer::vertex) return interpolated(samples);
    std::vector<RowBlend> blends(samples.size());
    parallelFor(samples.size(), samplesPerTask, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) blends[i] = blendAt(samples[i]);
    });
    const auto shaded =
        shade(std::move(blends), [&](std::size_t i) { return samples[i].position; });
    std::vector<glm::vec3> radiance(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      radiance[i] = leaving(samples[i], glm::vec3(shaded[i]));
    return radiance;
  }

 private:
  /// The rows of a sample's point.
  RowBlend blendAt(const SurfaceSample& sample) const {
    const bool onReceiver = sample.point.object == MeshPoint::onReceiver;
    const MeshPoint point =
        onReceiver ? ReceiverGrid(scene_.receiver.value()).pointAt(sample.position) : sample.point;
    const std::uint32_t first =
        onReceiver ? transfer_->firstRows.back() : transfer_->firstRows[point.object];
    return {glm::uvec4(point.vertices + first, 0), glm::vec4(point.weights, 0)};
  }

  /// Radiance that leaves a sample's surface, from that of its rows. Nothing is known of backs.
  glm::vec3 leaving(const SurfaceSample& sample, const glm::vec3& ofRows) const {
    if (sample.point.fromBehind) return glm::vec3(0);
    const std::size_t part =
        sample.point.object == MeshPoint::onReceiver ? scene_.objects.size() : sample.point.object;
    return transfer_->holdsAlbedo[part] ? ofRows : sample.albedo * ofRows;
  }

  /// On the engine; `positionOf` is that of a receiver.
  template <typename PositionOf>
  std::vector<glm::vec4> shade(std::vector<RowBlend> blends, const PositionOf& positionOf) {
    TransferReceivers receivers{std::move(blends), {}};
    receivers.lightWeights.resize(receivers.size() * lightCount_);
    parallelFor(receivers.size(), samplesPerTask, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        weighLights(scene_.light, positionOf(i),
                    std::span(receivers.lightWeights).subspan(i * lightCount_, lightCount_));
    });
    return engine_->shadeByTransfer(receivers, &times_);
  }

  void shadeVertices() {
    const TriangleMesh vertices = wholeSceneMesh(scene_);
    std::vector<RowBlend> blends;
    for (std::uint32_t row = 0; row < vertices.positions.size(); ++row)
      blends.push_back({{row, 0, 0, 0}, {1, 0, 0, 0}});
    ofVertices_ = shade(std::move(blends), [&](std::size_t i) { return vertices.positions[i]; });
  }

  std::vector<glm::vec3> interpolated(std::span<const SurfaceSample> samples) {
    if (ofVertices_.empty()) shadeVertices();
    const Stopwatch watch;
    std::vector<glm::vec3> radiance(samples.size());
    parallelFor(samples.size(), samplesPerTask, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const RowBlend blend = blendAt(samples[i]);
        glm::vec4 sum(0);
        for (int k = 0; k < 3; ++k) sum += blend.weights[k] * ofVertices_[blend.rows[k]];
        radiance[i] = leaving(samples[i], glm::vec3(sum));
      }
    });
    times_.total += watch.total();
    return radiance;
  }

  const Scene& scene_;
  std::shared_ptr<Engine> engine_;
  std::shared_ptr<const SceneTransfer> transfer_;
  ShadedPer per_;
  LightCoefficients coefficients_;
  std::size_t lightCount_ = 0;
  std::vector<glm::vec4> ofVertices_;  ///< per vertex: radiance of the rows; empty: not yet known
};

}  // namespace

std::unique_ptr<RadianceMethod> makeTransferMethod(const Scene& scene,
                                                   std::shared_ptr<Engine> engine,
                                                   std::shared_ptr<const SceneTransfer> transfer,
                                                   ShadedPer per) {
  return std::make_unique<TransferMethod>(scene, std::move(engine), std::move(transfer), per);
}

}  // namespace haarlight
