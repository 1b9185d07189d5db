#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "shadow/cell_code.h"
#include "solids/axis_box.h"

namespace haarlight {

/// The cube that an octree divides: around a box, and larger than it by less than a deepest cell,
/// so that a face of the box does not lie between two cells, which then would both hold it.
struct OctreeCube {
  glm::dvec3 lower{0};
  double edge = 0;  ///< 0 for a box that is a point

  OctreeCube() = default;
  /// Not for an empty box.
  explicit OctreeCube(const AxisBox& box);

  double edgeAt(int depth) const { return edge / (1 << depth); }
  AxisBox box(const CellCode& cell) const;
  /// The deepest cell in which a point lies; the nearest one for points outside.
  CellCode deepestCellAt(const glm::dvec3& point) const;

  /// The least depth at which cells, but for that difference, are at most this large; the deepest
  /// when none are. Throws InputError unless detail is a positive number.
  int depthForDetail(double detail) const;
};

/// A part of a receiver's surface that is all in shadow, or all in light.
struct ShadowLeaf {
  CellCode cell;
  bool inShadow = false;
  bool byRay = false;  ///< not proved: it holds for one point of the surface in the cell

  bool operator==(const ShadowLeaf&) const = default;
};

/// Which part of a receiver lies in shadow: the leaves of an octree that the surface reaches,
/// sorted by their codes. There are no nodes above them and no pointers.
class ShadowOctree {
 public:
  ShadowOctree() = default;
  /// Leaves that overlap nowhere, in any order.
  ShadowOctree(const OctreeCube& cube, std::vector<ShadowLeaf> leaves);

  const OctreeCube& cube() const { return cube_; }
  const std::vector<ShadowLeaf>& leaves() const { return leaves_; }

  /// The leaf in which a point of the surface lies. Nothing for a point that no leaf holds: it lies
  /// off the surface.
  std::optional<ShadowLeaf> leafAt(const glm::dvec3& point) const;

  /// The same for a point that rounding has moved off the surface by up to `reach` along each axis:
  /// if no leaf holds it, one that the cube of that size around it meets.
  std::optional<ShadowLeaf> leafNear(const glm::dvec3& point, double reach) const;

  /// Whether a point of the surface lies in a leaf that is in shadow.
  bool isInShadow(const glm::dvec3& point) const;

 private:
  OctreeCube cube_;
  std::vector<ShadowLeaf> leaves_;
};

}  // namespace haarlight
