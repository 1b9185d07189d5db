#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "solids/shape_geometry.h"

namespace haarlight {

namespace {

double slope(const ConeShape& shape) {
  return (shape.topRadius - shape.radius) / shape.height;
}

/// Of the cone without caps, through a point near it.
glm::dvec3 sideNormal(const ConeShape& shape, const glm::dvec3& point) {
  const double distance = distanceFromAxis(point);
  if (distance == 0) return {0, std::copysign(1.0, -slope(shape)), 0};  // the apex
  return glm::normalize(glm::dvec3(point.x / distance, -slope(shape), point.z / distance));
}

/// a s² + 2 b s + c
struct Quadratic {
  double a, b, c;
};

/// x² + z² − radius(y)² along a line: negative inside the cone, and inside its mirror image beyond
/// the apex.
Quadratic alongLine(const ConeShape& shape, const CenteredLine& line) {
  const glm::dvec3 p = line.point, d = line.direction;
  const double change = slope(shape) * d.y;
  const double radius = (shape.radius + shape.topRadius) / 2 + slope(shape) * p.y;
  return {d.x * d.x + d.z * d.z - change * change, p.x * d.x + p.z * d.z - radius * change,
          p.x * p.x + p.z * p.z - radius * radius};
}

/// Both roots, the smaller first, of a quadratic whose discriminant is not negative. Where a is
/// (nearly) zero, one of them is (nearly) infinite and the other as exact as ever.
std::array<double, 2> roots(const Quadratic& f, double discriminant) {
  const double sum = -(f.b + std::copysign(std::sqrt(discriminant), f.b));
  if (sum == 0) return {0, 0};
  const auto [low, high] = std::minmax({sum / f.a, f.c / sum});
  return {low, high};
}

/// The position in a chord next to the axis, from where a thin cone loses no digits.
double nextToAxis(const Chord& chord, const CenteredLine& line) {
  const glm::dvec2 point(line.point.x, line.point.z), across(line.direction.x, line.direction.z);
  const double squared = glm::dot(across, across);
  return squared == 0
             ? 0
             : std::clamp(-glm::dot(point, across) / squared, chord.enter.at, chord.exit.at);
}

/// Keeps the part of a chord where the line's quadratic is not positive. The chord lies within the
/// slab of the caps, on one side of the apex, so this is one part, but for rounding.
void cutBySide(Chord& chord, const ConeShape& shape, const CenteredLine& line) {
  const double origin = nextToAxis(chord, line);
  const Quadratic f = alongLine(shape, {line.at(origin), line.direction});
  const double discriminant = f.b * f.b - f.a * f.c;
  const bool constant = f.a == 0 && f.b == 0;
  if (constant || discriminant < 0) {  // one sign everywhere
    if (f.a > 0 || f.c > 0) chord.clear();
    return;
  }
  auto [low, high] = roots(f, discriminant);
  low += origin, high += origin;
  const auto enterSide = [&](double s) { chord.enterAt(s, sideNormal(shape, line.at(s))); };
  const auto exitSide = [&](double s) { chord.exitAt(s, sideNormal(shape, line.at(s))); };
  if (f.a >= 0) {
    enterSide(low), exitSide(high);
  } else if (low - chord.enter.at > chord.exit.at - high) {
    exitSide(low);
  } else {
    enterSide(high);
  }
}

}  // namespace

bool containsPoint(const ConeShape& shape, const glm::dvec3& point) {
  const double widest = std::max(shape.radius, shape.topRadius);
  const double radius = (shape.radius + shape.topRadius) / 2 + slope(shape) * point.y;
  return std::abs(point.y) <= (1 + onSurface) * shape.height / 2 &&
         distanceFromAxis(point) <= radius + onSurface * widest;
}

glm::dvec3 furthestPoint(const ConeShape& shape, const glm::dvec3& direction) {
  const double across = distanceFromAxis(direction);
  const glm::dvec2 outwards =
      across == 0 ? glm::dvec2(0) : glm::dvec2(direction.x, direction.z) / across;
  const double gain = direction.y * shape.height + across * (shape.topRadius - shape.radius);
  const bool atTop = gain > 0;
  const double radius = atTop ? shape.topRadius : shape.radius;
  return {radius * outwards.x, (atTop ? 0.5 : -0.5) * shape.height, radius * outwards.y};
}

SurfaceCrossings crossings(const ConeShape& shape, const CenteredLine& line) {
  Chord chord;
  chord.cutBySlab(line, 1, shape.height / 2);
  if (!chord.isEmpty()) cutBySide(chord, shape, line);
  return chord.ends();
}

}  // namespace haarlight
