#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// Unit vertex normals: the triangles' normals weighted by their angles at the vertex (Thürmer and
/// Wüthrich 1998), which do not depend on how a surface is cut into triangles. A vertex for which
/// that gives no direction has the normal +y.
std::vector<glm::vec3> computeVertexNormals(const std::vector<glm::vec3>& positions,
                                            const std::vector<glm::uvec3>& triangles);

/// `vector` scaled to length 1, or zero when it is not finite or has no direction.
glm::vec3 normalizedOrZero(const glm::dvec3& vector);

}  // namespace haarlight
