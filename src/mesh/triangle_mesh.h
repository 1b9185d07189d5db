#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace haarlight {

/// An indexed triangle mesh. `normals` holds one unit vector per vertex.
struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::uvec3> triangles;
};

}  // namespace haarlight
