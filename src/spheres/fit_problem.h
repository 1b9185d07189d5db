#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "spheres/solid_grid.h"

namespace haarlight {

/// What balls are fitted to, all in the unit frame.
struct FitProblem {
  TriangleMesh mesh;
  SolidGrid solid;
  std::vector<glm::vec3> surface;   ///< points spread over the surface, for the search
  std::vector<glm::vec3> interior;  ///< the same for the inside; for a cover only
  /// Points that a cover must hold, for a cover only: vertices, triangle centres, and many more on
  /// the surface.
  std::vector<glm::vec3> demanded;
};

}  // namespace haarlight
