#pragma once

/// Scenes of solids and meshes, and what exact rays say, triangle by triangle in double precision.

#include <optional>
#include <variant>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shadow/octree_refinement.h"
#include "shadow/shadow_light.h"
#include "solids/solid_samples.h"

namespace haarlight::test {

using SceneObject = std::variant<Solid, TriangleMesh>;

/// A ball, a knot, an open bowl, a flat sheet, or triangles at random, turned, about 1 in size and
/// moved by at most `reach` along each axis.
TriangleMesh randomMesh(int kind, double reach, RandomNumbers& random);
inline constexpr int meshKinds = 5;

/// Adds a mesh's triangles to another's, scaled and moved, and turned inside out if wanted.
void add(TriangleMesh& mesh, const TriangleMesh& other, float scale, const glm::vec3& place,
         bool turned);

/// Balls and knots, some within or across others, some turned inside out, and some whose corners
/// are moved at random, so that they cross themselves. Closed.
TriangleMesh randomClosedMesh(RandomNumbers& random);

struct ObjectSample {
  glm::dvec3 position;
  glm::dvec3 normal;
  std::size_t triangle = 0;  ///< of a mesh
};

ObjectSample randomSample(const SceneObject& object, RandomNumbers& random);

/// A point of the surface within `reach` of another along each axis, if it finds one.
std::optional<ObjectSample> sampleNear(const SceneObject& object, const glm::dvec3& place,
                                       double reach, RandomNumbers& random);

/// Where a segment from t = 0 to 1 meets a triangle.
std::optional<double> meets(const glm::dvec3& from, const glm::dvec3& way, const TriangleMesh& mesh,
                            std::size_t triangle);

/// Whether a point of an object's surface lies in shadow; of a convex solid's, in that of others.
bool isInShadow(const std::vector<SceneObject>& objects, std::size_t receiver,
                const ObjectSample& sample, const ShadowLight& light);

struct SceneShadows {
  SceneShadows(const std::vector<SceneObject>& objects, const ShadowLight& light,
               const OctreeDepths& depths);

  std::vector<ShadowOctree> octrees;
  OctreeCounts counts;
};

}  // namespace haarlight::test
