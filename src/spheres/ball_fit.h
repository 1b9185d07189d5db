#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "spheres/enclosing_ball.h"
#include "spheres/solid_grid.h"

namespace haarlight {

struct BallFit {
  Ball ball;
  double cost = 0;  ///< outsideCost of the ball
};

/// Volume of a ball outside the solid, comparable between balls of all sizes.
double outsideCost(const Ball& ball, const SolidGrid& solid);

/// The ball around all points whose volume outside the solid is least, searched from a centre by
/// Powell's method (Wang et al. 2006, §4.2); `polished` adds a pattern search, which takes as long
/// again. There must be a point.
BallFit fitAround(std::span<const glm::vec3> points, const glm::dvec3& start,
                  const SolidGrid& solid, bool polished);

}  // namespace haarlight
