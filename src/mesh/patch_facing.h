#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/connectivity.h"
#include "mesh/surface_patches.h"

namespace haarlight {

struct PatchFacing {
  std::vector<std::uint8_t> turn;   ///< by patch: whether its triangles are to be turned over
  std::size_t turnedTriangles = 0;  ///< that faced the other way than most of their patch's area
  std::size_t turnedPatches = 0;    ///< that faced the other way, by most of their area
};

/// Decides which side of each patch is the outer one.
///
/// A patch whose volume has the same sign for every apex in its bounding box (all closed ones, and
/// those with small holes) faces outwards. Only when it lies inside another such patch and the two
/// faced opposite ways in the input, each with three quarters of its area or more, is it the wall
/// of a cavity and faces inwards. Other patches may be pieces of one surface: they face as most of
/// their area did in the input, all turned over together when most of the area of the patches above
/// was (when there is none: when the volume of all pieces together is negative).
///
/// `triangles`: neighbours within a patch agree; `asInput` tells which of them face as they did in
/// the input. The result does not depend on which way the input faced as a whole.
PatchFacing facePatches(std::span<const glm::vec3> positions,
                        std::span<const VertexTriple> triangles,
                        std::span<const std::uint8_t> asInput, const SurfacePatches& patches);

}  // namespace haarlight
