#pragma once

#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "render/progress.h"
#include "scene/scene_description.h"
#include "spheres/sphere_set.h"

namespace haarlight {

/// What an object can be fitted as.
struct ObjectPose {
  const TriangleMesh& loaded;  ///< as its file has it
  const TriangleMesh& local;   ///< as it is at second 0, in its own coordinates
  const TriangleMesh& world;   ///< the same in the world
};

/// An object's spheres, and the mesh that they stand in for, vertex by vertex that of the pose.
struct ObjectSpheres {
  SphereSet set;
  /// One of the three of the pose, in whose coordinates the spheres are.
  const TriangleMesh& fitted;
};

/// Fits or reads the spheres that an object asks for. A set is made for the local mesh, so that
/// where it stands does not matter; where its transform stretches it unevenly, for the mesh in the
/// world. The file of a set may also be made for the mesh as loaded; when it is for neither,
/// `warnings` gets a line. A fitted set is kept in the cache folder and found again by the mesh's
/// hash. A solid that is a sphere gets itself, however many are asked for. Throws InputError.
ObjectSpheres spheresOf(const ObjectDescription& description, const ObjectPose& pose,
                        std::vector<std::string>& warnings, const Progress& progress);

/// Spheres moved by a matrix; radii by its largest factor along an axis.
std::vector<Sphere> transformed(std::vector<Sphere> spheres, const glm::mat4& matrix);

}  // namespace haarlight
