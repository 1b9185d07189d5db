#pragma once

#include "hard_shadow/shadow_comparison.h"
#include "image/image.h"

namespace haarlight {

/// The runs' pictures side by side at an exposure of `stops`, with labels; below them, where one of
/// them is exact, in grey with the differences from it in colour. Linear, ready for writePng.
Image shadowSheet(const ShadowComparison& comparison, float stops);

}  // namespace haarlight
