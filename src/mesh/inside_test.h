#pragma once

#include <glm/vec3.hpp>

#include "mesh/ray_scene.h"
#include "mesh/triangle_mesh.h"

namespace haarlight {

/// Tells whether points lie inside a mesh, by the majority of five rays in directions without a
/// relation to each other. A ray counts the sides of the surface it leaves and enters; any surplus
/// means inside, so overlapping parts work as their union and it does not matter which way the
/// triangles face. One ray is right for a closed mesh; the majority is what lets a mesh with holes
/// that let less than half of the rays through still have an inside. (A generalised winding number
/// copes with more damage, but takes the sum over all triangles, or a tree of its own, per point.)
class InsideTest {
 public:
  explicit InsideTest(const TriangleMesh& mesh);

  /// Safe to call from several threads.
  bool contains(const glm::vec3& point) const;

 private:
  RayScene scene_;
};

/// One step of a walk along a ray through all surfaces it meets.
struct Crossing {
  float distance;  ///< in lengths of the direction
  int turn;        ///< +1 where the ray leaves the side the triangles face away from, else -1
};

/// All crossings of a ray in order of distance.
std::vector<Crossing> crossingsAlong(const RayScene& scene, const glm::vec3& origin,
                                     const glm::vec3& direction);

}  // namespace haarlight
