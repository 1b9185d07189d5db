#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "shadow/shadow_light.h"
#include "shadow/shaft.h"

namespace haarlight {

/// A shaft and its cell as edges look at them.
struct ShaftView {
  glm::dvec3 origin;           ///< a point light's place, else 0
  glm::dvec3 middle{0}, half;  ///< of the cell, from the origin
  glm::dvec3 way{0};           ///< from the cell to where a directional light's shaft ends
  double furthest = 0;         ///< from a point light to the cell, at most
  double margin = 0;           ///< how far from the edge points count

  /// The margin is larger than rounding.
  ShaftView(const Shaft& shaft, double margin);

  double reach(const glm::dvec3& normal) const { return glm::dot(half, glm::abs(normal)); }
};

/// The shadow of an edge: all points that have one of its points on their way to the light. A piece
/// of a plane through the light, which begins at the edge and has no end.
class alignas(64) EdgeShadow {
 public:
  EdgeShadow(const glm::dvec3& a, const glm::dvec3& b, const ShadowLight& light);

  /// False only if no point within the margin of the edge lies in the shaft: if a plane parallel to
  /// the light's rays keeps the cell apart from the edge's shadow, or one that has the edge on the
  /// side away from cell and light. The light must be the one that was given.
  bool mayReach(const ShaftView& shaft) const;

 private:
  /// Parallel to light's rays: both ends of the edge are between `low` and `high` along the normal,
  /// and so is a point light.
  struct LightPlane {
    glm::dvec3 normal{0};
    double length = 0, low = 0, high = 0;

    bool keepsApart(const ShaftView& shaft, double magnification) const;
  };
  /// The edge does not go above it.
  struct EdgePlane {
    glm::dvec3 normal{0};
    double length = 0, edge = 0;
    double light = 0;  ///< how far above it the light is; infinitely, if it has no place

    bool keepsApart(const ShaftView& shaft) const;
  };

  class Planes;

  LightPlane along_;                 ///< the plane in which the shadow lies; tells most shafts
  double distance_;                  ///< of a point light from the edge; else infinity
  std::array<EdgePlane, 6> beyond_;  ///< across the axes, and through the edge
  std::array<LightPlane, 6> ends_;   ///< through the ends of the edge
};

}  // namespace haarlight
