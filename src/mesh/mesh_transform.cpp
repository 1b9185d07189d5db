#include "mesh/mesh_transform.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "mesh/vertex_normals.h"

namespace haarlight {

namespace {

/// The inverse transpose up to a positive factor; it also exists for a matrix that flattens.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

}  // namespace

TriangleMesh transformed(const TriangleMesh& mesh, const glm::mat4& matrix) {
  TriangleMesh result = mesh;
  const glm::dmat3 linear(matrix);
  const glm::dmat3 forNormals = normalMatrix(linear);
  for (auto& position : result.positions) position = glm::vec3(matrix * glm::vec4(position, 1));
  for (auto& normal : result.normals) {
    const glm::vec3 turned = normalizedOrZero(forNormals * glm::dvec3(normal));
    if (turned != glm::vec3(0)) normal = turned;
  }
  if (glm::determinant(linear) < 0)
    for (auto& triangle : result.triangles) std::swap(triangle.y, triangle.z);
  return result;
}

}  // namespace haarlight
