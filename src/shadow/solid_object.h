#pragma once

#include <memory>

#include "shadow/shadow_object.h"
#include "solids/solid.h"

namespace haarlight {

/// A convex solid casts a convex shadow, so that a cell whose eight corners lie in it does too, and
/// casts none on a cell whose shaft it does not meet. For a torus, balls around the cell on its way
/// to the light are compared with its distance (torus_shadow.h).
std::unique_ptr<ShadowObject> makeShadowObject(const Solid& solid);

}  // namespace haarlight
