#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/scene.h"

namespace haarlight {

/// Where a sample lies on the scene's objects, for methods that know something of their vertices.
/// On a solid, which has none, `vertices` and `weights` mean nothing.
struct MeshPoint {
  static constexpr std::uint32_t onReceiver = ~0u;

  std::uint32_t object = onReceiver;  ///< index of the object, or the receiver
  glm::uvec3 vertices{0};             ///< the object's, of the triangle that holds the point
  glm::vec3 weights{1, 0, 0};         ///< of those, Σ = 1
  bool fromBehind = false;            ///< seen from the side that the vertices' normals turn from
};

/// A point of a surface at which radiance is wanted.
struct SurfaceSample {
  glm::vec3 position;
  glm::vec3 normal;           ///< unit, for shading
  glm::vec3 geometricNormal;  ///< unit, of the surface itself, on the seen side
  glm::vec3 albedo;
  MeshPoint point;
};

/// The receiver's samples at its texels' centres: columns along +x, rows along +z, row by row.
std::vector<SurfaceSample> planeSamples(const ReceiverDescription& receiver);

/// The same in tiles (engine/tile_order.h), in which engines shade them fastest.
std::vector<SurfaceSample> planeSamplesInTiles(const ReceiverDescription& receiver);

/// One sample per vertex of the scene's object with an index, be it of a solid's stand-in, whose
/// vertices lie on the solid.
std::vector<SurfaceSample> vertexSamples(const Scene& scene, std::size_t object);

}  // namespace haarlight
