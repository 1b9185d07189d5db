#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spheres/enclosing_ball.h"
#include "spheres/fit_monitor.h"
#include "spheres/fit_problem.h"

namespace haarlight {

/// Variational sphere set approximation (Wang et al. 2006): balls that cover surface and inside
/// with the least summed volume outside the solid.
///
/// From seeds far from each other, points flood into clusters (floodFill) and each ball moves to
/// where it holds its cluster at the least cost, by Powell's method, in turn until the sum stalls.
/// Then one ball at a time is teleported: taken from where others overlap it most to where another
/// bulges out most, which is divided; the balls around both places settle; what does not lower the
/// sum is undone. In the end the demanded points that are still outside are taken up, and the balls
/// around them settle again.
std::vector<Ball> fitCover(const FitProblem& problem, std::size_t count, std::uint64_t seed,
                           FitMonitor& monitor);

}  // namespace haarlight
