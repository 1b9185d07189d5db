#include "mesh_shadow/edge_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace haarlight {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double distanceFromOrigin(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 way = b - a;
  const double squared = glm::dot(way, way);
  const double t = squared > 0 ? glm::clamp(-glm::dot(a, way) / squared, 0.0, 1.0) : 0;
  return glm::length(a + t * way);
}

/// The normals of planes that are parallel to a direction and to one of the axes.
std::array<glm::dvec3, 3> normalsAcross(const glm::dvec3& way) {
  return {glm::dvec3(0, -way.z, way.y), {way.z, 0, -way.x}, {-way.y, way.x, 0}};
}

}  // namespace

ShaftView::ShaftView(const Shaft& shaft, double edgeMargin)
    : origin(0), half(0.5 * (shaft.cell().upper - shaft.cell().lower)), margin(edgeMargin) {
  if (const auto* point = std::get_if<PointLight>(&shaft.light())) {
    origin = point->position;
    furthest = shaft.length() + shaft.radiusAt(0);
  } else {
    way = shaft.length() * shaft.towards();
  }
  middle = shaft.center() - origin;
}

/// An edge relative to the origin, for which planes are looked for.
class EdgeShadow::Planes {
 public:
  Planes(const glm::dvec3& a, const glm::dvec3& b, const ShadowLight& light) : a_(a), b_(b) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
      a_ -= point->position, b_ -= point->position;
      isPoint_ = true;
    } else {
      towards_ = std::get<DirectionalLight>(light).towards;
    }
  }

  glm::dvec3 along() const { return b_ - a_; }
  glm::dvec3 wayThroughA() const { return isPoint_ ? a_ : towards_; }
  glm::dvec3 wayThroughB() const { return isPoint_ ? b_ : towards_; }
  double lightDistance() const { return isPoint_ ? distanceFromOrigin(a_, b_) : infinity; }

  LightPlane lightPlane(const glm::dvec3& normal) const {
    const double atA = glm::dot(normal, a_), atB = glm::dot(normal, b_);
    const auto [low, high] = std::minmax({atA, atB, isPoint_ ? 0 : atA});
    return {normal, glm::length(normal), low, high};
  }

  EdgePlane edgePlane(const glm::dvec3& normal) const {
    const double slope = isPoint_ ? -glm::dot(normal, a_ + b_) : glm::dot(normal, towards_);
    const glm::dvec3 upwards = slope < 0 ? -normal : normal;
    const double edge = std::max(glm::dot(upwards, a_), glm::dot(upwards, b_));
    const double light = isPoint_ ? -edge : slope == 0 ? 0 : infinity;
    return {upwards, glm::length(normal), edge, light};
  }

 private:
  glm::dvec3 a_, b_, towards_{0};
  bool isPoint_ = false;
};

EdgeShadow::EdgeShadow(const glm::dvec3& a, const glm::dvec3& b, const ShadowLight& light) {
  const Planes planes(a, b, light);
  distance_ = planes.lightDistance();
  along_ = planes.lightPlane(glm::cross(planes.along(), planes.wayThroughA()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ends_[axis] = planes.lightPlane(normalsAcross(planes.wayThroughA())[axis]);
    ends_[axis + 3] = planes.lightPlane(normalsAcross(planes.wayThroughB())[axis]);
    glm::dvec3 unit(0);
    unit[axis] = 1;
    beyond_[axis] = planes.edgePlane(unit);
    beyond_[axis + 3] = planes.edgePlane(normalsAcross(planes.along())[axis]);
  }
}

/// A step from the edge, seen from a point light, is larger at the cell.
bool EdgeShadow::LightPlane::keepsApart(const ShaftView& shaft, double magnification) const {
  const double middle = glm::dot(normal, shaft.middle), reach = shaft.reach(normal);
  const double way = glm::dot(normal, shaft.way), margin = shaft.margin * length;
  return middle - reach + std::min(way, 0.0) > magnification * (high + margin) ||
         middle + reach + std::max(way, 0.0) < magnification * (low - margin);
}

bool EdgeShadow::EdgePlane::keepsApart(const ShaftView& shaft) const {
  const double margin = shaft.margin * length;
  return light > margin && glm::dot(normal, shaft.middle) - shaft.reach(normal) > edge + margin;
}

bool EdgeShadow::mayReach(const ShaftView& shaft) const {
  if (distance_ <= shaft.margin) return true;
  const double magnification =
      distance_ < infinity ? shaft.furthest / (distance_ - shaft.margin) : 1;
  if (along_.keepsApart(shaft, magnification)) return false;
  for (const EdgePlane& plane : beyond_)
    if (plane.keepsApart(shaft)) return false;
  for (const LightPlane& plane : ends_)
    if (plane.keepsApart(shaft, magnification)) return false;
  return true;
}

}  // namespace haarlight
