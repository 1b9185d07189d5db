#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace haarlight {

/// Groups points by k-means: starts from points far from each other (Gonzalez 1985), the first
/// chosen by `seed`, then a few rounds of Lloyd's algorithm. Returns a group below `count` for each
/// point; there may be empty groups.
std::vector<std::uint32_t> clusterPoints(std::span<const glm::vec3> points, std::size_t count,
                                         std::uint64_t seed);

}  // namespace haarlight
