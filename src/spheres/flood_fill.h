#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "spheres/solid_grid.h"

namespace haarlight {

/// Gives every point to one of the centres (Wang et al. 2006, §4.1): balls start around the centres
/// with radius 0 and grow as points join them; points are taken in order of their distance to the
/// nearest centre, so that all balls grow alike, and each joins the ball whose volume outside the
/// solid that raises least, or of several that it does not raise the one that it is deepest in.
/// Returns the centre's index for each point.
std::vector<std::uint32_t> floodFill(std::span<const glm::vec3> points,
                                     std::span<const glm::dvec3> centers, const SolidGrid& solid);

}  // namespace haarlight
