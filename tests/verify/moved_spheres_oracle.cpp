#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "oracle.h"

namespace haarlight::test {

namespace {

/// The value, which no float32 operation on the way to it may have rounded.
double unrounded(double value) {
  if (double(float(value)) != value)
    throw std::logic_error("a moved sphere is rounded: choose numbers of fewer digits");
  return value;
}

Sphere movedSphere(std::span<const std::uint32_t> list, std::span<const glm::vec4> weights,
                   const glm::dvec2& factors, std::span<const glm::vec4> vertices) {
  glm::dvec3 center(0);
  for (std::size_t k = 0; k < list.size(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      center[axis] += unrounded(double(weights[k].x) * double(vertices[list[k]][axis]));
  double mean = 0, reach = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const glm::dvec3 d = glm::dvec3(vertices[list[k]]) - center;
    mean += unrounded(double(weights[k].y) * unrounded(glm::dot(d, d)));
    reach = std::max(reach, double(weights[k].z) * glm::dot(d, d));
  }
  const double squared = unrounded(factors.x * mean + factors.y * reach);
  const double radius = unrounded(std::sqrt(squared));
  if (radius * radius != squared) throw std::logic_error("a moved sphere's radius is rounded");
  return {{unrounded(center.x), unrounded(center.y), unrounded(center.z)}, float(radius)};
}

}  // namespace

std::vector<Sphere> oracleMovedSpheres(const SphereBinding& binding,
                                       std::span<const glm::vec4> vertices) {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < binding.radiusFactors.size(); ++i) {
    const std::size_t first = binding.listStarts[i], count = binding.listStarts[i + 1] - first;
    spheres.push_back(movedSphere(std::span(binding.vertices).subspan(first, count),
                                  std::span(binding.weights).subspan(first, count),
                                  glm::dvec2(binding.radiusFactors[i]), vertices));
  }
  return spheres;
}

}  // namespace haarlight::test
