#include "render/surface_sample.h"

#include "engine/tile_order.h"

namespace haarlight {

std::vector<SurfaceSample> planeSamples(const ReceiverDescription& receiver) {
  const glm::vec3 up(0, 1, 0);
  std::vector<SurfaceSample> samples;
  samples.reserve(std::size_t(receiver.samples.x) * receiver.samples.y);
  for (int row = 0; row < receiver.samples.y; ++row)
    for (int column = 0; column < receiver.samples.x; ++column) {
      const double x = ((column + 0.5) / receiver.samples.x - 0.5) * receiver.size.x;
      const double z = ((row + 0.5) / receiver.samples.y - 0.5) * receiver.size.y;
      samples.push_back(
          {glm::vec3(receiver.center + glm::dvec3(x, 0, z)), up, up, glm::vec3(receiver.albedo)});
    }
  return samples;
}

std::vector<SurfaceSample> planeSamplesInTiles(const ReceiverDescription& receiver) {
  return inOrder(planeSamples(receiver), tileOrder(receiver.samples.x, receiver.samples.y));
}

std::vector<SurfaceSample> vertexSamples(const SceneObject& object) {
  std::vector<SurfaceSample> samples;
  samples.reserve(object.mesh.positions.size());
  for (std::size_t i = 0; i < object.mesh.positions.size(); ++i)
    samples.push_back(
        {object.mesh.positions[i], object.mesh.normals[i], object.mesh.normals[i], object.albedo});
  return samples;
}

}  // namespace haarlight
