#include "mesh_shadow/edge_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "shadow/box_shadow.h"

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

/// A cell relative to the edge's origin.
struct EdgeShadow::Cell {
  glm::dvec3 middle, half;
  double length;         ///< of its way to a directional light
  double margin;         ///< of the edge
  double magnification;  ///< how much larger than at the edge a step is at the cell, at most

  double reach(const glm::dvec3& normal) const { return glm::dot(half, glm::abs(normal)); }
};

EdgeShadow::EdgeShadow(const glm::dvec3& a, const glm::dvec3& b, const ShadowLight& light)
    : bounds_{glm::min(a, b), glm::max(a, b)}, origin_(a), towards_(0) {
  const auto* point = std::get_if<PointLight>(&light);
  if (point)
    origin_ = point->position;
  else
    towards_ = glm::normalize(std::get<DirectionalLight>(light).towards);
  a_ = a - origin_, b_ = b - origin_;
  distance_ = distanceFromOrigin(a_, b_);
  const glm::dvec3 wayA = point ? a_ : towards_, wayB = point ? b_ : towards_;
  along_ = lightPlane(glm::cross(b_ - a_, wayA));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ends_[axis] = lightPlane(normalsAcross(wayA)[axis]);
    ends_[axis + 3] = lightPlane(normalsAcross(wayB)[axis]);
    edges_[axis] = edgePlane(normalsAcross(b_ - a_)[axis]);
  }
}

EdgeShadow::LightPlane EdgeShadow::lightPlane(const glm::dvec3& normal) const {
  const auto [low, high] = std::minmax({0.0, glm::dot(normal, a_), glm::dot(normal, b_)});
  return {normal, glm::length(normal), low, high};
}

EdgeShadow::EdgePlane EdgeShadow::edgePlane(const glm::dvec3& normal) const {
  const double edge = glm::dot(normal, a_), slope = glm::dot(normal, towards_);
  const bool isPoint = towards_ == glm::dvec3(0);
  const double towardsLight = isPoint ? -edge : slope;
  const double sign = towardsLight < 0 ? -1 : 1;
  const bool isLevel = towardsLight == 0;
  const double light = isPoint || isLevel ? std::abs(towardsLight) : infinity;
  return {sign * normal, glm::length(normal), sign * edge, light};
}

/// A step from the edge, seen from a point light, is larger at the cell.
bool EdgeShadow::isApart(const Cell& cell, const LightPlane& plane) const {
  const double middle = glm::dot(plane.normal, cell.middle), reach = cell.reach(plane.normal);
  const double way = cell.length * glm::dot(plane.normal, towards_);
  const double margin = cell.margin * plane.length;
  return middle - reach + std::min(way, 0.0) > cell.magnification * (plane.high + margin) ||
         middle + reach + std::max(way, 0.0) < cell.magnification * (plane.low - margin);
}

bool EdgeShadow::isApart(const Cell& cell, const EdgePlane& plane) const {
  const double margin = cell.margin * plane.length;
  return plane.light > margin &&
         glm::dot(plane.normal, cell.middle) - cell.reach(plane.normal) > plane.edge + margin;
}

bool EdgeShadow::mayReach(const Shaft& shaft, double margin) const {
  const bool isPoint = std::holds_alternative<PointLight>(shaft.light());
  if (isPoint && distance_ <= margin) return true;
  const AxisBox& box = shaft.cell();
  Cell cell{box.center() - origin_, 0.5 * (box.upper - box.lower), 0, margin, 1};
  if (isPoint)
    cell.magnification = (shaft.length() + shaft.radiusAt(0)) / (distance_ - margin);
  else
    cell.length = shaft.length();
  if (isApart(cell, along_)) return false;
  const AxisBox around{bounds_.lower - margin, bounds_.upper + margin};
  if (shadowOf(around, box, shaft.light()) == BoxShadow::none) return false;
  const auto keepsApart = [&](const auto& plane) { return isApart(cell, plane); };
  return std::ranges::none_of(ends_, keepsApart) && std::ranges::none_of(edges_, keepsApart);
}

}  // namespace haarlight
