#include "app/scene_case.h"

#include <algorithm>

#include "render/moving_scene.h"
#include "render/render_image.h"
#include "scene/keyframes.h"
#include "scene/scene_file.h"

namespace haarlight {

namespace {

/// Notes the samples it is asked for instead of shading them.
class SampleRecorder final : public RadianceMethod {
 public:
  std::string name() const override { return "recorder"; }
  std::string deviceName() const override { return "host"; }
  void sceneChanged(bool) override {}
  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    for (const SurfaceSample& sample : samples) receivers_.add(sample.position, sample.normal);
    return std::vector<glm::vec3>(samples.size());
  }
  const Receivers& receivers() const { return receivers_; }

 private:
  Receivers receivers_;
};

}  // namespace

verify::Case sceneCase(const std::string& name, int width, const Progress& progress) {
  SceneDescription description = readScene(name);
  ImageDescription& image = description.image;
  image.height = std::max(1, width * image.height / image.width);
  image.width = width;
  image.samplesPerPixel = 1;
  MovingScene moving(description, progress);
  const int middleFrame = (description.animation.firstFrame + description.animation.lastFrame) / 2;
  const double seconds = frameSeconds(description.animation, middleFrame);
  moving.show(seconds);
  const Scene& scene = moving.scene();

  SampleRecorder recorder;
  const RenderedImage picture =
      ScreenSampler(scene, cameraAt(description.camera, seconds), image).render(recorder, progress);
  verify::Case result;
  result.name = "scene " + name;
  result.spheres = scene.blockerSpheres();
  result.binding = moving.binding();
  result.vertices.assign(moving.boundVertices().begin(), moving.boundVertices().end());
  result.receivers = recorder.receivers();
  result.light = scene.light.projection.cube;
  result.frameWidth = image.width;
  result.frameHeight = image.height;
  for (std::size_t pixel = 0; pixel < picture.surfaceMask.size(); ++pixel)
    if (picture.surfaceMask[pixel]) result.pixels.push_back(std::uint32_t(pixel));
  result.hasDenormals = verify::involvesDenormals(result);
  return result;
}

}  // namespace haarlight
