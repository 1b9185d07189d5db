#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/mesh_measures.h"
#include "mesh/triangle_mesh.h"
#include "motion/vertex_motion.h"
#include "scene/axis.h"
#include "scene/playback.h"

namespace haarlight {

/// An angle, finite, by the scene's seconds.
using AngleOverTime = std::function<double(double sceneSeconds)>;

/// What twisted() and bent() (motion/deformers.h) do over time.
struct TwistOverTime {
  Axis axis = Axis::y;
  AngleOverTime degrees;
};
struct BendOverTime {
  Axis axis = Axis::y;
  Axis towards = Axis::z;
  AngleOverTime degrees;
};

/// All that can change the vertices of a mesh, in the order in which it is applied.
struct MeshDeformation {
  std::unique_ptr<VertexMotion> vertices;  ///< null: none
  Playback playback;                       ///< of `vertices`
  std::optional<TwistOverTime> twist;
  std::optional<BendOverTime> bend;
};

/// A mesh whose vertices move in its own coordinates. The same time gives the same bits, whatever
/// was asked for before: twist and bend go by the box of the mesh at rest.
class DeformingMesh {
 public:
  /// Throws std::invalid_argument when `deformation` is for another number of vertices.
  explicit DeformingMesh(TriangleMesh rest, MeshDeformation deformation = {});

  /// As it was loaded.
  const TriangleMesh& rest() const { return rest_; }

  /// Whether anything makes it differ from rest(), be it at all times alike.
  bool deforms() const;

  /// Whether positions may differ from one time to another.
  bool moves() const;

  /// Throws InputError as VertexMotion::positions does.
  std::vector<glm::vec3> positions(double sceneSeconds);

  /// The mesh at a time. When it deforms, normals are computed from the positions at all times, so
  /// that they do not jump where it passes through rest; at edges whose sides have vertices of
  /// their own the normals of the sides stay apart. When it does not, it is rest() with its own
  /// normals.
  TriangleMesh meshAt(double sceneSeconds);

 private:
  TriangleMesh rest_;
  MeshDeformation deformation_;
  BoundingBox box_;
};

}  // namespace haarlight
