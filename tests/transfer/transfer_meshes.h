#pragma once

/// Meshes whose transfer is known.

#include <glm/geometric.hpp>

#include "test_meshes.h"

namespace haarlight::test {

/// Every triangle with vertices and normals of its own.
inline TriangleMesh faceted(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 corners[]{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const glm::vec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const auto first = static_cast<std::uint32_t>(result.positions.size());
    for (const glm::vec3& corner : corners) {
      result.positions.push_back(corner);
      result.normals.push_back(normal);
    }
    result.triangles.emplace_back(first, first + 1, first + 2);
  }
  return result;
}

/// A box seen from inside.
inline TriangleMesh room() {
  return faceted(turnedOver(box({-1, -2, -1.5f}, {1, 2, 1.5f})));
}

/// A mesh on the unit sphere seen from inside.
inline TriangleMesh fromWithin(TriangleMesh mesh) {
  mesh = turnedOver(std::move(mesh));
  mesh.normals.clear();
  for (const glm::vec3& p : mesh.positions) mesh.normals.push_back(-glm::normalize(p));
  return mesh;
}

}  // namespace haarlight::test
