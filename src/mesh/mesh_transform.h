#pragma once

#include <glm/mat4x4.hpp>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// The mesh moved by an affine matrix. Normals go by the inverse transpose; a mirroring matrix also
/// turns the triangles round, so that normals and winding still agree.
TriangleMesh transformed(const TriangleMesh& mesh, const glm::mat4& matrix);

}  // namespace haarlight
