#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "solids/axis_box.h"
#include "solids/placement.h"
#include "solids/ray.h"
#include "solids/shapes.h"

namespace haarlight {

/// Where a ray meets the surface of a solid.
struct SolidHit {
  double t = 0;          ///< in lengths of the ray's direction
  glm::dvec3 normal{0};  ///< unit, outwards
};

/// A parametric solid somewhere in the world, answered for by formulas, never by polygons. All
/// questions are in world coordinates and in double precision; formulas and accuracy are in
/// docs/lod_shadows.md. Values, so that threads may share them.
class Solid {
 public:
  /// Throws InputError when the measures are none of a solid's (see checkShape).
  explicit Solid(const Shape& shape, const Placement& placement = {});

  const Shape& shape() const { return shape_; }
  const Placement& placement() const { return placement_; }

  /// False for the torus alone.
  bool isConvex() const;

  /// The smallest box with axis-parallel faces around it, in closed form.
  AxisBox bounds() const;

  /// Whether a point lies inside or on the surface: as far as rounding can tell, which is 10⁻¹² of
  /// the measures.
  bool contains(const glm::dvec3& point) const;

  /// The point of the solid that lies furthest along a direction, which is not zero; one of them
  /// where there are many.
  glm::dvec3 support(const glm::dvec3& direction) const;

  /// Where the ray first meets the surface between near and far; it leaves the solid there when it
  /// starts inside. From a point of the surface it meets that at a t of about 0, which a small
  /// `near` passes over. Rays that touch the surface, or run within it, meet it as far as rounding
  /// can tell. No hit when the direction is zero or not finite.
  std::optional<SolidHit> intersect(const Ray& ray) const;

  /// Whether any point of the ray between near and far lies in the solid or on it: whether the
  /// solid stands in the way of light. The ray may lie inside altogether.
  bool blocks(const Ray& ray) const;

 private:
  Shape shape_;
  Placement placement_;
};

}  // namespace haarlight
