#pragma once

#include <span>

#include "mesh/triangle_mesh.h"
#include "scene/fit_objective.h"
#include "visibility/sphere_binding.h"

namespace haarlight {

/// Binds spheres to the vertices of the mesh as it stands, so that moveSpheres takes them along
/// when the vertices move. Every triangle belongs to the sphere that reaches farthest beyond its
/// corners, and a sphere follows the corners of its triangles, weighted by area; where those lie
/// too close to a plane or a line to say how space moves there, also the vertices nearest to it.
///
/// Guaranteed, but for rounding:
/// - the vertices where they are now give the spheres as they are now;
/// - an affine motion of all vertices moves centres by the same motion, and a similarity scales
///   radii by its factor;
/// - FitObjective::cover: a triangle whose corners all lie in its sphere now lies in it however the
///   vertices move (a ball is convex). The radius keeps its ratio to the farthest of those corners.
/// - FitObjective::shadow: the radius keeps its ratio to the root mean square distance of the
///   vertices, so that stretching in one direction counts by a third in squares.
///
/// `spheres` may be of any number; throws InputError when the mesh has no triangle.
SphereBinding bindSpheres(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                          FitObjective objective);

}  // namespace haarlight
