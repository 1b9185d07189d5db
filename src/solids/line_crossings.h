#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>

namespace haarlight {

/// A line by its point next to the origin and its unit direction, so that positions on it lose no
/// digits to the distance at which a ray starts.
struct CenteredLine {
  glm::dvec3 point;
  glm::dvec3 direction;

  glm::dvec3 at(double s) const { return point + s * direction; }
};

/// Where a line passes through a surface.
struct SurfaceCrossing {
  double at = 0;         ///< position on the line
  glm::dvec3 normal{0};  ///< unit, outwards
};

/// At most four of them, in ascending order; two at one place where the line only touches.
class SurfaceCrossings {
 public:
  void add(const SurfaceCrossing& crossing) { items_[count_++] = crossing; }
  const SurfaceCrossing* begin() const { return items_.data(); }
  const SurfaceCrossing* end() const { return items_.data() + count_; }

 private:
  std::array<SurfaceCrossing, 4> items_;
  int count_ = 0;
};

/// The part of a line inside a convex body, from everything down to nothing.
struct Chord {
  SurfaceCrossing enter{-std::numeric_limits<double>::infinity()};
  SurfaceCrossing exit{std::numeric_limits<double>::infinity()};

  bool isEmpty() const { return !(enter.at <= exit.at); }
  void clear() { enter.at = std::numeric_limits<double>::infinity(), exit.at = -enter.at; }
  void enterAt(double s, const glm::dvec3& normal) {
    if (s > enter.at) enter = {s, normal};
  }
  void exitAt(double s, const glm::dvec3& normal) {
    if (s < exit.at) exit = {s, normal};
  }
  /// Keeps what lies between the two planes at ± halfSize across an axis (0, 1, 2).
  void cutBySlab(const CenteredLine& line, int axis, double halfSize);
  SurfaceCrossings ends() const;
};

}  // namespace haarlight
