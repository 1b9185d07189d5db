#pragma once

#include <variant>

#include "mesh/triangle_mesh.h"
#include "solids/solid.h"

namespace haarlight {

/// An object that may stand in the way of light.
using Occluder = std::variant<const Solid*, const TriangleMesh*>;

}  // namespace haarlight
