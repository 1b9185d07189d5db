#pragma once

#include "mesh/connectivity.h"
#include "mesh_shadow/triangle_box.h"

namespace haarlight {

/// A triangle whose corners have numbers, which are the same at one position only.
struct NumberedTriangle {
  const TriangleCorners& corners;
  const VertexTriple& numbers;
};

/// False only if the triangles have no point in common but for the corners that both have, and the
/// edge between these: if a plane separates them, on which the one has no more than that.
bool mayTouchElsewhere(const NumberedTriangle& a, const NumberedTriangle& b);

}  // namespace haarlight
