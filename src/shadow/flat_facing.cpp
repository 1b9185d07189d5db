#include "shadow/flat_facing.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "solids/shape_geometry.h"

namespace haarlight {

namespace {

/// The light and a cell, as a solid sees them.
class OwnView {
 public:
  OwnView(const Solid& solid, const AxisBox& cell, const ShadowLight& light)
      : center_(solid.placement().toOwnPoint(cell.center())) {
    const glm::dvec3 half = cell.upper - cell.center();
    const glm::dmat3& rotation = solid.placement().rotation();
    for (int axis = 0; axis < 3; ++axis) half_[axis] = glm::dot(glm::abs(rotation[axis]), half);
    if (const auto* point = std::get_if<PointLight>(&light)) {
      light_ = solid.placement().toOwnPoint(point->position);
      isPoint_ = true;
    } else {
      light_ = glm::normalize(
          solid.placement().toOwnDirection(std::get<DirectionalLight>(light).towards));
    }
  }

  /// Whether a face at `side` (1 or −1) times `place` along an axis faces the light, within the
  /// cell.
  bool seesFace(int axis, double side, double place) const {
    const double height = side * light_[axis] - (isPoint_ ? place : 0);
    return height > tolerance(place) && std::abs(side * center_[axis] - place) <= half_[axis];
  }

  /// Whether a frustum's side faces the light anywhere: unless that is within the infinite cone.
  bool seesSide(const ConeShape& cone) const {
    const double slope = (cone.topRadius - cone.radius) / cone.height;
    const double radius = (isPoint_ ? (cone.radius + cone.topRadius) / 2 : 0) + slope * light_.y;
    return distanceFromAxis(light_) > radius + tolerance(cone.radius);
  }

 private:
  double tolerance(double measure) const {
    return onSurface * (isPoint_ ? measure + glm::length(light_) : 1);
  }

  glm::dvec3 center_, half_{0}, light_{0};
  bool isPoint_ = false;
};

struct FacesAway {
  OwnView view;

  bool operator()(const EllipsoidShape&) const { return false; }
  bool operator()(const TorusShape&) const { return false; }
  bool operator()(const BoxShape& box) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0})
        if (view.seesFace(axis, side, box.halfSizes[axis])) return false;
    return true;
  }
  bool operator()(const ConeShape& cone) const {
    return !view.seesSide(cone) && !view.seesFace(1, 1, cone.height / 2) &&
           !view.seesFace(1, -1, cone.height / 2);
  }
};

}  // namespace

bool flatSurfaceFacesAway(const Solid& solid, const AxisBox& cell, const ShadowLight& light) {
  const FacesAway facesAway{OwnView(solid, cell, light)};
  return std::visit([&](const auto& shape) { return facesAway(surfaceOf(shape)); }, solid.shape());
}

}  // namespace haarlight
