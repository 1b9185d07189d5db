#pragma once

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// Whether the vertices that triangles use lie in one plane, on one line or at one point, up to a
/// millionth of their extent and the rounding of their coordinates. A mesh without triangles does.
bool liesInPlane(const TriangleMesh& mesh);

}  // namespace haarlight
