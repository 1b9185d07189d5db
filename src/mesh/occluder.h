#pragma once

#include <variant>

#include "mesh/triangle_mesh.h"
#include "solids/axis_box.h"
#include "solids/solid.h"

namespace haarlight {

/// An object that may stand in the way of light.
using Occluder = std::variant<const Solid*, const TriangleMesh*>;

/// The smallest box around it with axis-parallel faces; empty for a mesh without triangles.
AxisBox boundsOf(const Occluder& shape);

}  // namespace haarlight
