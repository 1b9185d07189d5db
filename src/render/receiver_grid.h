#pragma once

#include "mesh/triangle_mesh.h"
#include "render/surface_sample.h"

namespace haarlight {

/// The receiver as two triangles that face up.
TriangleMesh receiverRectangle(const ReceiverDescription& receiver);

/// The receiver as a mesh, for methods that work on vertices: one vertex at every corner of its
/// texels, (columns + 1) × (rows + 1) of them row by row, and each texel is two triangles.
class ReceiverGrid {
 public:
  explicit ReceiverGrid(const ReceiverDescription& receiver) : receiver_(receiver) {}

  std::size_t vertexCount() const;

  /// Positions and normals; no triangles.
  TriangleMesh vertices() const;

  /// The vertices and weights of a point of the receiver.
  MeshPoint pointAt(const glm::vec3& position) const;

 private:
  ReceiverDescription receiver_;
};

}  // namespace haarlight
