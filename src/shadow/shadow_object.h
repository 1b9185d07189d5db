#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "shadow/shaft.h"
#include "solids/axis_box.h"

namespace haarlight {

/// What is known of the shadow that an object casts on a cell.
enum class CellShadow {
  none,     ///< no point of the cell has a point of the object between itself and the light
  all,      ///< every point has
  uniform,  ///< one of the two: a ray from any point of the cell tells which
  unknown   ///< the cell must be divided, or decided for one of its points
};

/// The numbers of those parts of an object that may matter in a cell, ascending. A cell's children
/// look at the cell's parts only.
using Parts = std::vector<std::uint32_t>;
using PartView = std::span<const std::uint32_t>;

/// What the octree asks of an object, as a receiver and as a caster of shadows. All answers that
/// say something hold for every point of the cell; when in doubt, objects give none. Any thread may
/// ask.
class ShadowObject {
 public:
  virtual ~ShadowObject() = default;

  virtual AxisBox bounds() const = 0;

  /// How far points of its surface may lie off it by rounding.
  virtual double tolerance() const = 0;

  // As a receiver.

  virtual Parts surfaceParts() const { return {}; }
  /// False only if no point of the surface lies in the cell. Adds those of the parts that may lie
  /// in it to `kept`.
  virtual bool surfaceReaches(const AxisBox& cell, PartView parts, Parts& kept) const = 0;
  /// A point of the surface in a cell that the surface reaches, with the parts that were kept.
  /// Where only the doubt left the cell standing, a point of the surface nearby.
  virtual glm::dvec3 surfacePoint(const AxisBox& cell, PartView parts) const = 0;

  // As a caster.

  virtual Parts casterParts() const { return {}; }
  /// Adds those of the parts that may matter in the shaft's cell to `kept`.
  virtual CellShadow shadowOn(const Shaft& shaft, PartView parts, Parts& kept) const = 0;

  // Of itself.

  /// Whether shadows on itself are the octree's business. A convex solid's surface lies in its own
  /// shadow exactly where it faces away from the light, which its normal tells.
  virtual bool castsOnItself() const = 0;
  virtual Parts ownCasterParts() const { return {}; }
  /// The same as shadowOn, for those points of the cell that belong to the own surface, whose parts
  /// in the cell are given; a point is not in its own way. `uniform` means that surface points of
  /// one sheet agree (addOwnStarts). Where castsOnItself() is false, only `all` says something: the
  /// whole surface in the cell faces away.
  virtual CellShadow ownShadowOn(const Shaft& shaft, PartView surface, PartView parts,
                                 Parts& kept) const = 0;
  /// From where a ray to the light is to start that asks for the own shadow of a point of the
  /// surface in a cell.
  virtual glm::dvec3 ownStart(const AxisBox& cell, PartView surface) const {
    return surfacePoint(cell, surface);
  }
  /// Adds such a start for every sheet of the surface in the cell; that of ownStart first.
  virtual void addOwnStarts(const AxisBox& cell, PartView surface,
                            std::vector<glm::dvec3>& starts) const {
    starts.push_back(ownStart(cell, surface));
  }
};

}  // namespace haarlight
