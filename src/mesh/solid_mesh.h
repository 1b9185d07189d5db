#pragma once

#include "mesh/triangle_mesh.h"
#include "solids/shapes.h"

namespace haarlight {

/// What is fine enough where polygons stand in for a solid, as when spheres are fitted to it.
inline constexpr int standInSegments = 64;

/// Polygons in place of a solid, in its own coordinates: closed, counter-clockwise as seen from
/// outside, with all vertices on the surface (as rounded to single precision) and its normals
/// there; at rims and edges every side has vertices of its own. `segments`, at least 3, go around
/// the axis, half as many from pole to pole or around a torus's tube; a box has 12 triangles.
/// Throws InputError when the shape is none (solids/solid_checks.h), std::invalid_argument for
/// fewer segments.
TriangleMesh solidMesh(const Shape& shape, int segments);

}  // namespace haarlight
