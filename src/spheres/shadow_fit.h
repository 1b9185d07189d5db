#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spheres/enclosing_ball.h"
#include "spheres/fit_monitor.h"
#include "spheres/fit_problem.h"

namespace haarlight {

/// Balls whose silhouettes differ least from the mesh's as seen from around it, and that take
/// little of the sky of its own surface (SilhouetteCover).
///
/// Balls that touch the surface from within are added one by one where they lower the error most;
/// then each in turn is moved and resized by Powell's method; then one ball at a time is
/// teleported: taken from where it is missed least to where a candidate helps most, and the balls
/// around both places settle; what does not lower the error is undone.
std::vector<Ball> fitShadow(const FitProblem& problem, std::size_t count, std::uint64_t seed,
                            FitMonitor& monitor);

}  // namespace haarlight
