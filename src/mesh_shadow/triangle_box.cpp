#include "mesh_shadow/triangle_box.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace haarlight {

namespace {

/// Whether two numbers lie beyond the same end of the interval [-reach, reach].
bool areBeyond(double a, double b, double reach) {
  return std::min(a, b) > reach || std::max(a, b) < -reach;
}

/// For the three axes across an edge and a coordinate axis, along which both ends of the edge have
/// one place, by which the third corner differs. Relative to the box's middle.
bool isSeparatedAcross(const glm::dvec3& edge, const glm::dvec3& end, const glm::dvec3& third,
                       const glm::dvec3& half) {
  const glm::dvec3 size = glm::abs(edge);
  return areBeyond(edge.y * end.z - edge.z * end.y, edge.y * third.z - edge.z * third.y,
                   half.y * size.z + half.z * size.y) ||
         areBeyond(edge.z * end.x - edge.x * end.z, edge.z * third.x - edge.x * third.z,
                   half.x * size.z + half.z * size.x) ||
         areBeyond(edge.x * end.y - edge.y * end.x, edge.x * third.y - edge.y * third.x,
                   half.x * size.y + half.y * size.x);
}

/// Where the perpendicular from a point meets a triangle.
std::optional<glm::dvec3> pointBelow(const glm::dvec3& point, const TriangleCorners& triangle) {
  const glm::dvec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
  const glm::dvec3 normal = glm::cross(ab, ac), way = point - triangle[0];
  const double squared = glm::dot(normal, normal);
  const double v = glm::dot(glm::cross(way, ac), normal);
  const double w = glm::dot(glm::cross(ab, way), normal);
  if (!(v >= 0 && w >= 0 && v + w <= squared) || squared == 0) return std::nullopt;
  return triangle[0] + v / squared * ab + w / squared * ac;
}

/// What planes cut out of a triangle.
class CutTriangle {
 public:
  explicit CutTriangle(const TriangleCorners& triangle) {
    std::copy(triangle.begin(), triangle.end(), corners_.begin());
  }

  /// Keeps the part where sign · coordinate ≤ sign · place.
  void cut(int axis, double sign, double place) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      const glm::dvec3 &a = corners_[i], &b = corners_[i + 1 < count_ ? i + 1 : 0];
      const double beyondA = sign * (a[axis] - place), beyondB = sign * (b[axis] - place);
      if (beyondA <= 0) next_[kept++] = a;
      if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0))
        next_[kept++] = a + beyondA / (beyondA - beyondB) * (b - a);
    }
    count_ = kept;
    std::copy_n(next_.begin(), count_, corners_.begin());
  }

  std::optional<glm::dvec3> middle() const {
    if (count_ == 0) return std::nullopt;
    glm::dvec3 sum(0);
    for (int i = 0; i < count_; ++i) sum += corners_[i];
    return sum / double(count_);
  }

 private:
  /// Each of six planes adds one corner at most, or half as many as there are where rounding has
  /// bent the polygon.
  static constexpr int mostCorners = 28;

  std::array<glm::dvec3, mostCorners> corners_{}, next_{};
  int count_ = 3;
};

}  // namespace

bool triangleMeetsBox(const TriangleCorners& triangle, const AxisBox& box) {
  const glm::dvec3 middle = box.center(), half = 0.5 * box.upper - 0.5 * box.lower;
  const glm::dvec3 a = triangle[0] - middle, b = triangle[1] - middle, c = triangle[2] - middle;
  const glm::dvec3 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
  if (!overlap(AxisBox{low, high}, AxisBox{-half, half})) return false;
  const glm::dvec3 ab = b - a, bc = c - b, ca = a - c, normal = glm::cross(ab, bc);
  if (std::abs(glm::dot(normal, a)) > glm::dot(half, glm::abs(normal))) return false;
  return !isSeparatedAcross(ab, a, c, half) && !isSeparatedAcross(bc, b, a, half) &&
         !isSeparatedAcross(ca, c, b, half);
}

bool segmentMeetsBox(const glm::dvec3& a, const glm::dvec3& b, const AxisBox& box) {
  return box.contains(a) || box.contains(b) || triangleMeetsBox({a, b, b}, box);
}

BoxedTriangle::BoxedTriangle(const TriangleCorners& triangle)
    : bounds{glm::min(glm::min(triangle[0], triangle[1]), triangle[2]),
             glm::max(glm::max(triangle[0], triangle[1]), triangle[2])},
      corners(triangle) {
  const glm::dvec3 extent = bounds.upper - bounds.lower;
  size = std::max({extent.x, extent.y, extent.z});
}

std::optional<glm::dvec3> pointInBoth(const TriangleCorners& triangle, const AxisBox& box) {
  const glm::dvec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  if (box.contains(middle)) return middle;
  if (const auto point = pointBelow(box.center(), triangle))
    if (box.contains(*point)) return point;
  CutTriangle rest(triangle);
  for (int axis = 0; axis < 3; ++axis) {
    rest.cut(axis, 1, box.upper[axis]);
    rest.cut(axis, -1, box.lower[axis]);
  }
  return rest.middle();
}

}  // namespace haarlight
