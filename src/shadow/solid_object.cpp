#include "shadow/solid_object.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "shadow/box_shadow.h"
#include "shadow/convex_gap.h"
#include "shadow/flat_facing.h"
#include "shadow/torus_shadow.h"

namespace haarlight {

namespace {

class SolidObject : public ShadowObject {
 public:
  explicit SolidObject(const Solid& solid)
      : solid_(solid), bounds_(solid.bounds()), tolerance_(4e-12 * largestCoordinate(bounds_)) {}

  AxisBox bounds() const override { return bounds_; }
  double tolerance() const override { return tolerance_; }

 protected:
  Solid solid_;
  AxisBox bounds_;
  double tolerance_;
};

class ConvexObject final : public SolidObject {
 public:
  using SolidObject::SolidObject;

  bool castsOnItself() const override { return false; }

  bool surfaceReaches(const AxisBox& cell, PartView, Parts&) const override {
    return !gapTo(cell).isApart && !std::ranges::all_of(cornersOf(cell), [&](const auto& corner) {
      return solid_.contains(corner);
    });
  }

  /// Where the way from a point of the solid in the cell to a corner outside leaves the solid.
  glm::dvec3 surfacePoint(const AxisBox& cell, PartView) const override {
    glm::dvec3 inside = gapTo(cell).nearest;
    glm::dvec3 outside = inside;
    for (const glm::dvec3& corner : cornersOf(cell))
      (solid_.contains(corner) ? inside : outside) = corner;
    const auto hit = solid_.intersect({inside, outside - inside, 0, 1});
    return hit ? inside + hit->t * (outside - inside) : inside;
  }

  CellShadow shadowOn(const Shaft& shaft, PartView, Parts&) const override {
    if (shadowOf(bounds_, shaft.cell(), shaft.light()) == BoxShadow::none) return CellShadow::none;
    const auto solid = [&](const glm::dvec3& direction) { return solid_.support(direction); };
    const auto way = [&](const glm::dvec3& direction) { return shaft.support(direction); };
    const glm::dvec3 start = bounds_.center() - shaft.center();
    if (gapBetween(solid, way, start, shaft.margin()).isApart) return CellShadow::none;
    return hidesCorners(shaft) ? CellShadow::all : CellShadow::unknown;
  }

  /// A point in light has points above it that the solid does not hide, and the cell, which is a
  /// little larger than what it stands for, has some of these.
  CellShadow ownShadowOn(const Shaft& shaft, PartView, PartView, Parts&) const override {
    const bool facesAway = flatSurfaceFacesAway(solid_, shaft.cell(), shaft.light());
    return facesAway || hidesCorners(shaft) ? CellShadow::all : CellShadow::unknown;
  }

 private:
  bool hidesCorners(const Shaft& shaft) const {
    return std::ranges::all_of(cornersOf(shaft.cell()), [&](const glm::dvec3& corner) {
      return solid_.blocks(segmentToLight(corner, shaft.light()));
    });
  }

  ConvexGap gapTo(const AxisBox& cell) const {
    const auto solid = [&](const glm::dvec3& direction) { return solid_.support(direction); };
    const auto box = [&](const glm::dvec3& direction) { return cornerAlong(cell, direction); };
    return gapBetween(solid, box, bounds_.center() - cell.center(), tolerance_);
  }
};

class TorusObject final : public SolidObject {
 public:
  explicit TorusObject(const Solid& torus) : SolidObject(torus), shadow_(torus) {}

  bool castsOnItself() const override { return true; }

  bool surfaceReaches(const AxisBox& cell, PartView, Parts&) const override {
    return std::abs(shadow_.distance(cell.center())) <= radiusOf(cell);
  }

  glm::dvec3 surfacePoint(const AxisBox& cell, PartView) const override {
    Search search{cell, shadow_.nearestSurfacePoint(cell.center()),
                  std::numeric_limits<double>::infinity()};
    constexpr int divisions = 4;
    look(search, cell, divisions);
    return search.best;
  }

  CellShadow shadowOn(const Shaft& shaft, PartView, Parts&) const override {
    if (shadowOf(bounds_, shaft.cell(), shaft.light()) == BoxShadow::none) return CellShadow::none;
    return shadow_.on(shaft, false);
  }
  CellShadow ownShadowOn(const Shaft& shaft, PartView, PartView, Parts&) const override {
    return shadow_.on(shaft, true);
  }

 private:
  /// For the surface's point next to a cell, among those next to the middles of its parts.
  struct Search {
    AxisBox cell;
    glm::dvec3 best;
    double distance;
  };

  double radiusOf(const AxisBox& box) const {
    return glm::distance(box.center(), box.upper) + tolerance_;
  }

  void look(Search& search, const AxisBox& box, int divisions) const {
    if (search.distance == 0 || !(std::abs(shadow_.distance(box.center())) <= radiusOf(box)))
      return;
    const glm::dvec3 point = shadow_.nearestSurfacePoint(box.center());
    const double distance =
        glm::distance(point, glm::clamp(point, search.cell.lower, search.cell.upper));
    if (distance < search.distance) search.best = point, search.distance = distance;
    if (divisions == 0) return;
    for (const glm::dvec3& corner : cornersOf(box))
      look(search, {glm::min(corner, box.center()), glm::max(corner, box.center())}, divisions - 1);
  }

  TorusShadow shadow_;
};

}  // namespace

std::unique_ptr<ShadowObject> makeShadowObject(const Solid& solid) {
  if (solid.isConvex()) return std::make_unique<ConvexObject>(solid);
  return std::make_unique<TorusObject>(solid);
}

}  // namespace haarlight
