#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace haarlight {

/// At most four points of the difference of two convex bodies, {a − b}, kept down to the smallest
/// face that holds their hull's point next to the origin.
class DifferenceSimplex {
 public:
  /// a − b, with a, a point of the first body. Afterwards nearest() is new.
  void add(const glm::dvec3& difference, const glm::dvec3& first);
  bool isEmpty() const { return count_ == 0; }

  /// The hull's point next to the origin, and the point of the first body that belongs to it.
  glm::dvec3 nearest() const;
  glm::dvec3 nearestOfFirst() const;

 private:
  struct Vertex {
    glm::dvec3 difference, first;
  };
  std::array<double, 4> weightsOf(const std::array<Vertex, 4>& face, int count) const;

  std::array<Vertex, 4> vertices_;
  std::array<double, 4> weights_{};
  int count_ = 0;
};

struct ConvexGap {
  bool isApart = false;  ///< proved: a plane keeps the bodies more than the margin apart
  /// Of the first body, next to the second, in which it lies where they meet, as far as the search
  /// has come.
  glm::dvec3 nearest{0};
};

/// Whether two convex bodies lie apart, by Gilbert, Johnson and Keerthi's search (1988). A body is
/// a function that gives its furthest point along a direction. The search proposes directions; what
/// it says is proved by the furthest points along them, whatever its rounding. The margin, above 0,
/// is for that of the furthest points. `start` is a direction from the second body to the first.
template <typename First, typename Second>
ConvexGap gapBetween(const First& first, const Second& second, const glm::dvec3& start,
                     double margin) {
  DifferenceSimplex simplex;
  glm::dvec3 across = start;
  constexpr int mostSteps = 32;
  for (int step = 0; step < mostSteps; ++step) {
    const double length = glm::length(across);
    if (!simplex.isEmpty() && length <= margin) break;
    const glm::dvec3 unit = length > 0 ? across / length : glm::dvec3(0, 1, 0);
    const glm::dvec3 a = first(-unit), difference = a - second(unit);
    const double gap = glm::dot(difference, unit);
    if (gap > margin) return {true, a};
    constexpr double noProgress = 1e-12;
    if (!simplex.isEmpty() && length - gap <= noProgress * length) break;
    simplex.add(difference, a);
    across = simplex.nearest();
  }
  return {false, simplex.nearestOfFirst()};
}

}  // namespace haarlight
