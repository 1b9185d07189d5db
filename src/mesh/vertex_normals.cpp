#include "mesh/vertex_normals.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace haarlight {

glm::vec3 normalizedOrZero(const glm::dvec3& vector) {
  const double length = std::sqrt(glm::dot(vector, vector));
  return std::isfinite(length) && length > 0 ? glm::vec3(vector / length) : glm::vec3(0);
}

std::vector<glm::vec3> computeVertexNormals(const std::vector<glm::vec3>& positions,
                                            const std::vector<glm::uvec3>& triangles) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0));
  for (const glm::uvec3& triangle : triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 at = positions[triangle[corner]];
      const glm::dvec3 next = glm::dvec3(positions[triangle[(corner + 1) % 3]]) - at;
      const glm::dvec3 previous = glm::dvec3(positions[triangle[(corner + 2) % 3]]) - at;
      const glm::dvec3 area = glm::cross(next, previous);
      const double length = std::sqrt(glm::dot(area, area));
      if (length > 0)
        sums[triangle[corner]] += area / length * std::atan2(length, glm::dot(next, previous));
    }
  }
  std::vector<glm::vec3> normals(positions.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    normals[i] = normalizedOrZero(sums[i]);
    if (normals[i] == glm::vec3(0)) normals[i] = {0, 1, 0};
  }
  return normals;
}

}  // namespace haarlight
