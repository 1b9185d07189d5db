#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "shadow/shadow_light.h"
#include "solids/axis_box.h"

namespace haarlight {

/// The corner of a box that lies furthest along a direction.
inline glm::dvec3 cornerAlong(const AxisBox& box, const glm::dvec3& direction) {
  return {direction.x < 0 ? box.lower.x : box.upper.x, direction.y < 0 ? box.lower.y : box.upper.y,
          direction.z < 0 ? box.lower.z : box.upper.z};
}

/// In the order of CellCode's children.
std::array<glm::dvec3, 8> cornersOf(const AxisBox& box);

double largestCoordinate(const AxisBox& box);

/// All points through which light goes, or would go, on its way to a cell: the convex hull of the
/// cell and a point light, or the cell swept towards a directional one until it has left the scene.
class Shaft {
 public:
  /// `scene` is a box around all that may cast a shadow.
  Shaft(const AxisBox& cell, const ShadowLight& light, const AxisBox& scene);

  const AxisBox& cell() const { return cell_; }
  const ShadowLight& light() const { return *light_; }

  /// Larger than what rounding does to places in the scene, and than the tolerance of
  /// Solid::contains.
  double margin() const { return margin_; }

  /// The point of the shaft that lies furthest along a direction.
  glm::dvec3 support(const glm::dvec3& direction) const;

  /// A ball around the cell, on its way to the light: at `length` it has left the scene or come to
  /// the light. All that leaves the cell for the light is in it at the same time, as the way of a
  /// point of the cell has its own length.
  glm::dvec3 center() const { return cell_.center(); }
  const glm::dvec3& towards() const { return towards_; }  ///< unit; zero if there is no way to go
  double length() const { return length_; }
  double radiusAt(double distance) const;
  /// By how much at most the unit vector from a point of the shaft to the light differs from
  /// towards().
  double spread() const;

 private:
  AxisBox cell_;
  const ShadowLight* light_;
  glm::dvec3 towards_{0};
  double length_ = 0, radius_ = 0, margin_ = 0;
};

}  // namespace haarlight
