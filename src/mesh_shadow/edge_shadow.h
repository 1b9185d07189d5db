#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "shadow/shadow_light.h"
#include "shadow/shaft.h"
#include "solids/axis_box.h"

namespace haarlight {

/// The shadow of an edge: all points that have one of its points on their way to the light. A piece
/// of a plane through the light, which begins at the edge and has no end.
class EdgeShadow {
 public:
  EdgeShadow(const glm::dvec3& a, const glm::dvec3& b, const ShadowLight& light);

  /// False only if no point within `margin` of the edge lies in the shaft: if a plane parallel to
  /// the light's rays keeps the cell apart from the edge's shadow, or one through the edge, or if
  /// the boxes around cell and edge do. The light must be the one that was given. The margin is
  /// larger than rounding.
  bool mayReach(const Shaft& shaft, double margin) const;

 private:
  /// Across the way of light through a point of the edge, so that the light lies in it: both ends
  /// of the edge are between `low` and `high`, and so is the light.
  struct LightPlane {
    glm::dvec3 normal{0};
    double length = 0, low = 0, high = 0;
  };
  /// Through the edge; the light is on the positive side.
  struct EdgePlane {
    glm::dvec3 normal{0};
    double length = 0, edge = 0;
    double light = 0;  ///< how far above the edge; of a directional light, infinity
  };
  struct Cell;

  LightPlane lightPlane(const glm::dvec3& normal) const;
  EdgePlane edgePlane(const glm::dvec3& normal) const;
  bool isApart(const Cell& cell, const LightPlane& plane) const;
  bool isApart(const Cell& cell, const EdgePlane& plane) const;

  AxisBox bounds_;
  glm::dvec3 origin_;    ///< a point light's place, else one end of the edge
  glm::dvec3 towards_;   ///< a directional light's direction, a unit vector, else zero
  double distance_ = 0;  ///< of a point light from the edge
  glm::dvec3 a_, b_;     ///< from the origin
  LightPlane along_;     ///< the plane in which the shadow lies
  std::array<LightPlane, 6> ends_;
  std::array<EdgePlane, 3> edges_;
};

}  // namespace haarlight
