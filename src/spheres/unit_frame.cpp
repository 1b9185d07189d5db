#include "spheres/unit_frame.h"

#include <algorithm>
#include <cmath>

#include "mesh/mesh_measures.h"

namespace haarlight {

UnitFrame::UnitFrame(const TriangleMesh& mesh) {
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  center_ = (glm::dvec3(box.upper) + glm::dvec3(box.lower)) / 2.0;
  int exponent = 0;
  std::frexp(std::max({extent.x, extent.y, extent.z}), &exponent);
  scale_ = std::ldexp(1.0, -exponent);
}

TriangleMesh UnitFrame::toUnit(const TriangleMesh& mesh) const {
  TriangleMesh result = mesh;
  for (auto& position : result.positions) position = toUnit(position);
  return result;
}

std::vector<Sphere> UnitFrame::toUnit(std::span<const Sphere> spheres) const {
  std::vector<Sphere> result(spheres.begin(), spheres.end());
  for (Sphere& sphere : result)
    sphere = {toUnit(sphere.center), static_cast<float>(sphere.radius * scale_)};
  return result;
}

}  // namespace haarlight
