#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/ray_scene.h"
#include "mesh/triangle_mesh.h"
#include "mesh/winding_number.h"

namespace haarlight {

/// Tells whether points lie inside a mesh: where its winding number is nearer to some whole number
/// other than 0 than to 0. So overlapping and touching parts work as their union, a shell inside
/// another that faces the other way is a cavity, a mesh with holes still has an inside, and it does
/// not matter which way all triangles face; neighbours must agree (prepareSolid sees to that).
class InsideTest {
 public:
  explicit InsideTest(const TriangleMesh& mesh);

  /// Safe to call from several threads.
  bool contains(const glm::vec3& point) const;

 private:
  WindingNumber windingNumber_;
};

/// One step of a walk along a ray through all surfaces it meets.
struct Crossing {
  float distance;  ///< in lengths of the direction
  int turn;        ///< +1 where the ray leaves the side the triangles face away from, else -1
};

/// All crossings of a ray in order of distance. Of surfaces that lie within a millionth of the
/// distance of each other, only the first is met.
std::vector<Crossing> crossingsAlong(const RayScene& scene, const glm::vec3& origin,
                                     const glm::vec3& direction);

}  // namespace haarlight
