#pragma once

#include <memory>

#include "mesh/triangle_mesh.h"
#include "shadow/shadow_light.h"
#include "shadow/shadow_object.h"

namespace haarlight {

/// A mesh for the octree, under one light; it is copied. Where no edge of its silhouette meets a
/// shaft, and no triangle its cell, all points of the cell see the light or none does, so that one
/// ray tells (docs/lod_shadows.md). Edges and triangles are handed down from cell to child. Throws
/// InputError when a coordinate is not finite. A light on the mesh leaves everything in its shadow.
///
/// A point of the mesh lies in the mesh's own shadow where another triangle than its own stands
/// between it and the light, further off than single precision's rounding, from whichever side that
/// sees it. So the parts of a closed mesh that face away are in shadow, which a mesh that does not
/// cross itself proves of all of them at once (hidden_triangles.h), and both sides of a sheet are
/// in light.
std::unique_ptr<ShadowObject> makeShadowObject(const TriangleMesh& mesh, const ShadowLight& light);

}  // namespace haarlight
