#include "motion/moving_mesh.h"

#include <stdexcept>
#include <utility>

#include "mesh/vertex_normals.h"
#include "motion/deformers.h"

namespace haarlight {

DeformingMesh::DeformingMesh(TriangleMesh rest, MeshDeformation deformation)
    : rest_(std::move(rest)), deformation_(std::move(deformation)), box_(boundingBox(rest_)) {
  const auto& vertices = deformation_.vertices;
  if (vertices && vertices->vertexCount() != rest_.positions.size())
    throw std::invalid_argument("the motion is for another number of vertices than the mesh has");
}

bool DeformingMesh::deforms() const {
  return deformation_.vertices || deformation_.twist || deformation_.bend;
}

bool DeformingMesh::moves() const {
  const auto& [vertices, playback, twist, bend] = deformation_;
  return (vertices && vertices->duration() > 0) || twist || bend;
}

std::vector<glm::vec3> DeformingMesh::positions(double sceneSeconds) {
  const auto& [vertices, playback, twist, bend] = deformation_;
  std::vector<glm::vec3> positions =
      vertices ? vertices->positions(motionSeconds(playback, vertices->duration(), sceneSeconds))
               : rest_.positions;
  if (twist) positions = twisted(positions, box_, twist->axis, twist->degrees(sceneSeconds));
  if (bend)
    positions = bent(positions, box_, bend->axis, bend->towards, bend->degrees(sceneSeconds));
  return positions;
}

TriangleMesh DeformingMesh::meshAt(double sceneSeconds) {
  if (!deforms()) return rest_;
  TriangleMesh mesh;
  mesh.positions = positions(sceneSeconds);
  mesh.normals = computeVertexNormals(mesh.positions, rest_.triangles);
  mesh.triangles = rest_.triangles;
  return mesh;
}

}  // namespace haarlight
