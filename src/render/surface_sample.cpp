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
      samples.push_back({glm::vec3(receiver.center + glm::dvec3(x, 0, z)),
                         up,
                         up,
                         glm::vec3(receiver.albedo),
                         {}});
    }
  return samples;
}

std::vector<SurfaceSample> planeSamplesInTiles(const ReceiverDescription& receiver) {
  return inOrder(planeSamples(receiver), tileOrder(receiver.samples.x, receiver.samples.y));
}

std::vector<SurfaceSample> vertexSamples(const Scene& scene, std::size_t object) {
  const TriangleMesh& mesh = scene.objects[object].mesh;
  const glm::vec3 albedo = scene.objects[object].albedo;
  std::vector<SurfaceSample> samples;
  samples.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    samples.push_back({mesh.positions[i], mesh.normals[i], mesh.normals[i], albedo,
                       MeshPoint{std::uint32_t(object), glm::uvec3(i)}});
  return samples;
}

}  // namespace haarlight
