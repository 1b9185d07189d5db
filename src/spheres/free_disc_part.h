#pragma once

#include <span>

#include "spheres/enclosing_ball.h"
#include "visibility/sphere.h"

namespace haarlight {

/// The part of a ball's disc that the spheres, which lie in the ball, leave free: 0 … 1, as a mean
/// over the directions from which the ball is seen from afar.
double meanFreePart(const Ball& ball, std::span<const Sphere> spheres);

}  // namespace haarlight
