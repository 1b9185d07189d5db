#pragma once

#include "mesh/embree_version.h"
#include "solids/solid.h"

namespace haarlight::embree {

/// Lets rays meet a solid as object `object` of a scene that is not yet committed: by its formulas,
/// in double precision. `solid` must stay where it is. What stands in the way of an occlusion ray
/// is the whole solid (Solid::blocks), be it that the ray lies inside.
void attachSolid(RTCDevice device, RTCScene scene, unsigned object, const Solid& solid);

}  // namespace haarlight::embree
