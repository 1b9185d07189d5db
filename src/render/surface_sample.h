#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/scene.h"

namespace haarlight {

/// A point of a surface at which radiance is wanted.
struct SurfaceSample {
  glm::vec3 position;
  glm::vec3 normal;           ///< unit, for shading
  glm::vec3 geometricNormal;  ///< unit, of the surface itself, on the seen side
  glm::vec3 albedo;
};

/// The receiver's samples at its texels' centres: columns along +x, rows along +z, row by row.
std::vector<SurfaceSample> planeSamples(const ReceiverDescription& receiver);

/// The same in tiles (engine/tile_order.h), in which engines shade them fastest.
std::vector<SurfaceSample> planeSamplesInTiles(const ReceiverDescription& receiver);

/// One sample per vertex.
std::vector<SurfaceSample> vertexSamples(const SceneObject& object);

}  // namespace haarlight
