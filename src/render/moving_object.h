#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motion/moving_mesh.h"
#include "scene/scene_description.h"
#include "solids/solid.h"

namespace haarlight {

/// An object's mesh, or its solid and the mesh that stands in for it, with all that moves it.
class MovingObject {
 public:
  /// Loads mesh and motion, or makes a stand-in mesh of standInSegments. `scene` gives what the
  /// object does not say: the height of the ground and frames per second. `warnings` gets one line
  /// for each thing unusual. Throws InputError.
  MovingObject(const ObjectDescription& description, const SceneDescription& scene,
               std::vector<std::string>& warnings);

  /// Whether vertices may be elsewhere at another time.
  bool moves() const { return motion_ || mesh_.moves(); }

  /// As its file has it.
  const TriangleMesh& loadedMesh() const { return mesh_.rest(); }
  /// At a second, in its own coordinates. Throws InputError as VertexMotion::positions does.
  TriangleMesh localMesh(double seconds) { return mesh_.meshAt(seconds); }
  glm::mat4 toWorld(double seconds) const;
  TriangleMesh worldMesh(double seconds);
  /// In the world; none for a mesh.
  std::optional<Solid> worldSolid(double seconds) const;

 private:
  glm::dmat4 exactToWorld(double seconds) const;

  DeformingMesh mesh_;
  glm::dmat4 toWorld_;
  glm::dvec3 pivot_;
  std::optional<MotionDescription> motion_;
  std::optional<Shape> solid_;  ///< as scaled by its transform
};

}  // namespace haarlight
