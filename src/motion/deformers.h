#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh_measures.h"
#include "scene/axis.h"

namespace haarlight {

/// Every point turned about the line through the middle of the box along `axis`, by
/// degrees · (h − ½), right-handed about +axis; h runs from 0 at the lower to 1 at the upper end of
/// the box, and on beyond. 0 degrees give the same bits.
std::vector<glm::vec3> twisted(std::span<const glm::vec3> positions, const BoundingBox& box,
                               Axis axis, double degrees);

/// The line through the middle of the box along `axis` bent to an arc of a circle of `degrees` in
/// total. Its length stays, its middle stays where it is, and both ends move towards +`towards`, or
/// away from it when degrees < 0. Cross-sections stay plane, of the same shape and perpendicular to
/// the line; those thicker than the radius of the arc meet on its inner side. 0 degrees give the
/// same bits. Throws std::invalid_argument when `towards` is `axis`.
std::vector<glm::vec3> bent(std::span<const glm::vec3> positions, const BoundingBox& box, Axis axis,
                            Axis towards, double degrees);

}  // namespace haarlight
