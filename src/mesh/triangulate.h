#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace haarlight {

/// Splits a polygon into points.size() - 2 triangles of indices into `points`, by cutting off ears
/// in the plane of the polygon's mean normal; a polygon that crosses itself is split as well, in
/// some way.
std::vector<std::array<std::uint32_t, 3>> triangulatePolygon(std::span<const glm::vec3> points);

}  // namespace haarlight
