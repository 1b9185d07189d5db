#include "benchmark/inputs.h"

#include "base/error.h"
#include "render/moving_scene.h"

namespace haarlight::benchmark {

namespace {

SceneDescription withSpheres(SceneDescription description, int count) {
  for (ObjectDescription& object : description.objects) object.spheres = count;
  return description;
}

}  // namespace

Inputs loadInputs(const SceneDescription& description, std::span<const int> sphereCounts,
                  const Progress& progress) {
  if (!description.receiver)
    throw InputError("the scene has no receiver plane, whose samples are measured");
  Inputs inputs;
  inputs.samples = planeSamplesInTiles(*description.receiver);
  for (SurfaceSample& sample : inputs.samples) sample.albedo = glm::vec3(1);
  inputs.receivers = receiversOf(inputs.samples);
  for (const int count : sphereCounts)
    inputs.scenes.push_back({count, loadScene(withSpheres(description, count), progress)});
  return inputs;
}

Receivers receiversOf(std::span<const SurfaceSample> samples) {
  Receivers receivers;
  for (const SurfaceSample& sample : samples) receivers.add(sample.position, sample.normal);
  return receivers;
}

}  // namespace haarlight::benchmark
