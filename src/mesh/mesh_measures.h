#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

struct BoundingBox {
  glm::vec3 lower{0};
  glm::vec3 upper{0};
};

/// Bounds of the vertices that triangles use; zero when there is no triangle.
BoundingBox boundingBox(const TriangleMesh& mesh);

/// Of the triangle with these corners; zero where they lie on a line.
inline double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::length(glm::cross(b - a, c - a)) / 2;
}

/// Whether its area is not zero, without the underflow of a length.
inline bool triangleHasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a) != glm::dvec3(0);
}

/// The enclosed volume by the divergence theorem; negative when the triangles face inwards. For an
/// open mesh it is that of the mesh closed by cones from the edges of its holes to the centre of
/// its bounding box.
double signedVolume(const TriangleMesh& mesh);

double surfaceArea(const TriangleMesh& mesh);

/// `count` points spread evenly over the area: the k-th lies in the k-th of `count` equal parts of
/// it, in the order of the triangles. The same for the same seed.
std::vector<glm::vec3> sampleSurface(const TriangleMesh& mesh, std::size_t count,
                                     std::uint64_t seed);

/// A point of the surface and the unit normal of its triangle.
struct SurfacePoint {
  glm::vec3 position;
  glm::vec3 normal;
};

/// The points of sampleSurface with normals.
std::vector<SurfacePoint> sampleSurfaceWithNormals(const TriangleMesh& mesh, std::size_t count,
                                                   std::uint64_t seed);

/// Checksum of positions and triangles; it tells whether a sphere set was made for this mesh.
std::uint64_t meshHash(const TriangleMesh& mesh);

}  // namespace haarlight
