#pragma once

#include <string>

#include "engine/engine.h"

namespace haarlight {

/// Asks the engine a small question whose answer is known, a few milliseconds' work: moved spheres,
/// bit cubes and Haar coefficients are compared with checksums of the right ones, radiance bit by
/// bit with the scalar engine's. `table` is the one the engine was made with. Returns what is
/// wrong, in words; empty when nothing is. The spheres have their rims on texel centres or their
/// sizes on bounds of the table's bins, so that a compiler that contracts a·b + c, or divides where
/// it should multiply, is noticed.
std::string selfTestFailure(Engine& engine, std::shared_ptr<const SphereTable> table);

}  // namespace haarlight
