#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "spheres/enclosing_ball.h"
#include "spheres/point_blocks.h"

namespace haarlight {

/// Receivers on the mesh itself, to tell how much of their sky a ball that stands in for their own
/// body takes away.
class SurfaceReceivers {
 public:
  /// `count` points spread evenly over the surface, which faces outwards.
  SurfaceReceivers(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

  /// Mean over all receivers of the part of their hemisphere that the ball takes from those in it:
  /// with v the direction to the centre, (1 + v·n) / 2 of the hemisphere, as engines see it, where
  /// the centre is above the horizon, and none where it is far enough below
  /// (visibility/sphere_bin.h). Zero for a ball without a radius.
  double blockedBy(const Ball& ball) const;

 private:
  PointBlocks points_;
  std::vector<glm::vec3> normals_;  ///< in the order of the blocks
};

}  // namespace haarlight
