#pragma once

#include "shadow/shadow_light.h"
#include "solids/axis_box.h"
#include "solids/solid.h"

namespace haarlight {

/// Whether all of a box's, cylinder's or cone's surface within a cell is seen to face away from the
/// light, or to be level with it as far as rounding can tell: what does not face away is one of its
/// flat faces, and the cell does not reach that one's plane. Light level with a face leaves a whole
/// face on the edge of shadows, where nothing else could tell. False for other solids.
bool flatSurfaceFacesAway(const Solid& solid, const AxisBox& cell, const ShadowLight& light);

}  // namespace haarlight
