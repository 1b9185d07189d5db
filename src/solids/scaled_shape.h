#pragma once

#include "solids/shapes.h"

namespace haarlight {

/// The shape with all its measures times a factor > 0.
Shape scaled(const Shape& shape, double factor);

}  // namespace haarlight
