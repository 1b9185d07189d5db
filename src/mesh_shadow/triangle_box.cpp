#include "mesh_shadow/triangle_box.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace haarlight {

namespace {

/// A triangle relative to the middle of a box of these half sizes.
struct CenteredPair {
  TriangleCorners triangle;
  glm::dvec3 half;

  bool isSeparatedBy(const glm::dvec3& axis) const {
    const auto [low, high] = std::minmax(
        {glm::dot(triangle[0], axis), glm::dot(triangle[1], axis), glm::dot(triangle[2], axis)});
    const double reach = glm::dot(half, glm::abs(axis));
    return low > reach || high < -reach;
  }
};

/// Keeps the part of a polygon where sign · coordinate ≤ sign · place.
void cut(std::vector<glm::dvec3>& polygon, int axis, double sign, double place) {
  std::vector<glm::dvec3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3& a = polygon[i];
    const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
    const double beyondA = sign * (a[axis] - place), beyondB = sign * (b[axis] - place);
    if (beyondA <= 0) result.push_back(a);
    if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0))
      result.push_back(a + beyondA / (beyondA - beyondB) * (b - a));
  }
  polygon = std::move(result);
}

}  // namespace

bool triangleMeetsBox(const TriangleCorners& triangle, const AxisBox& box) {
  const glm::dvec3 middle = box.center();
  const CenteredPair pair{{triangle[0] - middle, triangle[1] - middle, triangle[2] - middle},
                          0.5 * box.upper - 0.5 * box.lower};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit(0);
    unit[axis] = 1;
    if (pair.isSeparatedBy(unit)) return false;
  }
  const glm::dvec3 edges[] = {triangle[1] - triangle[0], triangle[2] - triangle[1],
                              triangle[0] - triangle[2]};
  if (pair.isSeparatedBy(glm::cross(edges[0], edges[1]))) return false;
  for (const glm::dvec3& edge : edges)
    for (const glm::dvec3& axis : {glm::dvec3(0, -edge.z, edge.y), glm::dvec3(edge.z, 0, -edge.x),
                                   glm::dvec3(-edge.y, edge.x, 0)})
      if (pair.isSeparatedBy(axis)) return false;
  return true;
}

std::optional<glm::dvec3> pointInBoth(const TriangleCorners& triangle, const AxisBox& box) {
  std::vector<glm::dvec3> polygon(triangle.begin(), triangle.end());
  for (int axis = 0; axis < 3; ++axis) {
    cut(polygon, axis, 1, box.upper[axis]);
    cut(polygon, axis, -1, box.lower[axis]);
  }
  if (polygon.empty()) return std::nullopt;
  glm::dvec3 sum(0);
  for (const glm::dvec3& corner : polygon) sum += corner;
  return sum / double(polygon.size());
}

}  // namespace haarlight
