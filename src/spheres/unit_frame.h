#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "visibility/sphere.h"

namespace haarlight {

/// Coordinates in which the bounding box of a mesh has its centre at the origin and a longest side
/// of 0.5 to 1. The factor is a power of two, so that it changes no bit of the mantissas: a mesh
/// and the same mesh at another power-of-two scale become the same numbers.
class UnitFrame {
 public:
  explicit UnitFrame(const TriangleMesh& mesh);

  glm::vec3 toUnit(const glm::vec3& point) const {
    return glm::vec3((glm::dvec3(point) - center_) * scale_);
  }
  glm::dvec3 fromUnit(const glm::dvec3& point) const { return point / scale_ + center_; }
  /// Unit lengths per length of the mesh's coordinates.
  double scale() const { return scale_; }

  TriangleMesh toUnit(const TriangleMesh& mesh) const;
  std::vector<Sphere> toUnit(std::span<const Sphere> spheres) const;

 private:
  glm::dvec3 center_;
  double scale_;
};

}  // namespace haarlight
