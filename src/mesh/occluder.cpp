#include "mesh/occluder.h"

#include "mesh/mesh_measures.h"

namespace haarlight {

AxisBox boundsOf(const Occluder& shape) {
  if (const auto* solid = std::get_if<const Solid*>(&shape)) return (*solid)->bounds();
  const TriangleMesh& mesh = *std::get<const TriangleMesh*>(shape);
  if (mesh.triangles.empty()) return {};
  const BoundingBox box = boundingBox(mesh);
  return {box.lower, box.upper};
}

}  // namespace haarlight
