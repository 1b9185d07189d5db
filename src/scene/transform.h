#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "scene/scene_description.h"

namespace haarlight {

/// The matrix that takes a mesh's points to world coordinates. `positions` are the mesh's vertices,
/// which `fit` and `rest` look at; `groundHeight` is the y of the plane that `rest` puts it on.
/// Throws InputError when `fit` is asked for and all positions are one point.
glm::dmat4 objectToWorld(const TransformDescription& transform,
                         std::span<const glm::vec3> positions, double groundHeight);

/// The same for a solid in its own coordinates (description.transform has no `fit` and one scale);
/// `rest` looks at the solid itself.
glm::dmat4 solidToWorld(const TransformDescription& transform, const Shape& shape,
                        double groundHeight);

/// The point that the object's own rotation and motion leave where it is, in world coordinates: its
/// origin, or with `fit` the middle of its bounding box, rested and translated. Parameters and
/// errors as for objectToWorld.
glm::dvec3 objectPivot(const TransformDescription& transform, std::span<const glm::vec3> positions,
                       double groundHeight);
glm::dvec3 solidPivot(const TransformDescription& transform, const Shape& shape,
                      double groundHeight);

/// The y of the plane that objects rest on: the receiver's, or 0 without one.
double groundHeight(const SceneDescription& scene);

}  // namespace haarlight
