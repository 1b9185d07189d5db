#include "solids/solid_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace haarlight::test {

namespace {

using std::numbers::pi;

SurfaceSample ofEllipsoid(const glm::dvec3& radii, double u, double v) {
  const double longitude = 2 * pi * u, latitude = pi * (v - 0.5);
  const glm::dvec3 unit(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                        std::cos(latitude) * std::sin(longitude));
  return {radii * unit, glm::normalize(unit / radii)};
}

SurfaceSample ofBox(const glm::dvec3& half, int part, double u, double v) {
  const int axis = part / 2;
  const double side = part % 2 ? 1 : -1;
  glm::dvec3 unit(0), normal(0);
  unit[axis] = normal[axis] = side;
  unit[(axis + 1) % 3] = 2 * u - 1;
  unit[(axis + 2) % 3] = 2 * v - 1;
  return {half * unit, normal};
}

SurfaceSample ofFrustum(const ConeShape& cone, int part, double u, double v) {
  const double angle = 2 * pi * u;
  const glm::dvec3 outwards(std::cos(angle), 0, std::sin(angle)), up(0, 1, 0);
  if (part == 1) return {cone.radius * v * outwards - cone.height / 2 * up, -up};
  if (part == 2) return {cone.topRadius * v * outwards + cone.height / 2 * up, up};
  const double radius = cone.radius * (1 - v) + cone.topRadius * v;
  return {radius * outwards + cone.height * (v - 0.5) * up,
          glm::normalize(cone.height * outwards + (cone.radius - cone.topRadius) * up)};
}

SurfaceSample ofTorus(const TorusShape& torus, double u, double v) {
  const glm::dvec3 outwards(std::cos(2 * pi * u), 0, std::sin(2 * pi * u)), up(0, 1, 0);
  const glm::dvec3 normal = std::cos(2 * pi * v) * outwards + std::sin(2 * pi * v) * up;
  return {torus.majorRadius * outwards + torus.minorRadius * normal, normal};
}

struct SampleAt {
  int part;
  double u, v;
  SurfaceSample operator()(const SphereShape& s) const {
    return ofEllipsoid(glm::dvec3(s.radius), u, v);
  }
  SurfaceSample operator()(const EllipsoidShape& s) const { return ofEllipsoid(s.radii, u, v); }
  SurfaceSample operator()(const BoxShape& s) const { return ofBox(s.halfSizes, part, u, v); }
  SurfaceSample operator()(const CylinderShape& s) const {
    return ofFrustum({s.radius, s.height, s.radius}, part, u, v);
  }
  SurfaceSample operator()(const ConeShape& s) const { return ofFrustum(s, part, u, v); }
  SurfaceSample operator()(const TorusShape& s) const { return ofTorus(s, u, v); }
};

struct ImplicitAt {
  glm::dvec3 p;
  double operator()(const SphereShape& s) const { return glm::length(p) - s.radius; }
  double operator()(const EllipsoidShape& s) const { return glm::length(p / s.radii) - 1; }
  double operator()(const BoxShape& s) const {
    const glm::dvec3 beyond = glm::abs(p) - s.halfSizes;
    return std::max({beyond.x, beyond.y, beyond.z});
  }
  double operator()(const CylinderShape& s) const {
    return std::max(std::hypot(p.x, p.z) - s.radius, std::abs(p.y) - s.height / 2);
  }
  double operator()(const ConeShape& s) const {
    const double up = p.y / s.height + 0.5;
    return std::max(std::hypot(p.x, p.z) - s.radius * (1 - up) - s.topRadius * up,
                    std::abs(p.y) - s.height / 2);
  }
  double operator()(const TorusShape& s) const {
    const double sum =
        glm::dot(p, p) + s.majorRadius * s.majorRadius - s.minorRadius * s.minorRadius;
    return sum * sum - 4 * s.majorRadius * s.majorRadius * (p.x * p.x + p.z * p.z);
  }
};

struct VolumeOf {
  double operator()(const SphereShape& s) const { return 4 * pi / 3 * std::pow(s.radius, 3); }
  double operator()(const EllipsoidShape& s) const {
    return 4 * pi / 3 * s.radii.x * s.radii.y * s.radii.z;
  }
  double operator()(const BoxShape& s) const {
    return 8 * s.halfSizes.x * s.halfSizes.y * s.halfSizes.z;
  }
  double operator()(const CylinderShape& s) const { return pi * s.radius * s.radius * s.height; }
  double operator()(const ConeShape& s) const {
    return pi / 3 * s.height *
           (s.radius * s.radius + s.radius * s.topRadius + s.topRadius * s.topRadius);
  }
  double operator()(const TorusShape& s) const {
    return 2 * pi * pi * s.majorRadius * s.minorRadius * s.minorRadius;
  }
};

}  // namespace

double uniform(RandomNumbers& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

glm::dvec3 randomPoint(RandomNumbers& random, double reach) {
  const double x = uniform(random, -reach, reach), y = uniform(random, -reach, reach);
  return {x, y, uniform(random, -reach, reach)};
}

glm::dvec3 randomDirection(RandomNumbers& random) {
  for (;;) {
    const glm::dvec3 point = randomPoint(random, 1);
    const double length = glm::length(point);
    if (length > 0.1 && length < 1) return point / length;
  }
}

glm::dmat3 randomRotation(RandomNumbers& random) {
  const glm::dvec3 x = randomDirection(random);
  const glm::dvec3 y = glm::normalize(glm::cross(x, randomDirection(random)));
  return {x, y, glm::cross(x, y)};
}

Shape randomShape(int kind, RandomNumbers& random) {
  const auto measure = [&] { return uniform(random, 0.2, 1); };
  const double a = measure(), b = measure(), c = measure();
  switch (kind) {
    case 0:
      return SphereShape{a};
    case 1:
      return EllipsoidShape{{a, b, c}};
    case 2:
      return BoxShape{{a, b, c}};
    case 3:
      return CylinderShape{a, b};
    case 4:
      return ConeShape{a, b, c < 0.6 ? 0 : c};
    default:
      return TorusShape{std::max(a, b), std::min(a, b)};
  }
}

Solid randomSolid(int kind, double reach, RandomNumbers& random) {
  const Shape shape = randomShape(kind, random);
  const glm::dvec3 translation = randomPoint(random, reach);
  return Solid(shape, Placement(translation, randomRotation(random)));
}

int surfaceParts(const Shape& shape) {
  const auto* cone = std::get_if<ConeShape>(&shape);
  if (cone && cone->topRadius == 0) return 2;  // without the cap at the top, part 2
  constexpr int parts[shapeKinds] = {1, 1, 6, 3, 3, 1};
  return parts[shape.index()];
}

SurfaceSample surfaceSample(const Solid& solid, int part, double u, double v) {
  const auto [position, normal] = std::visit(SampleAt{part, u, v}, solid.shape());
  const glm::dmat3 rotation = solid.placement().rotation();
  return {rotation * position + solid.placement().translation(), rotation * normal};
}

SurfaceSample randomSurfaceSample(const Solid& solid, RandomNumbers& random) {
  const int part = int(random() % std::uint64_t(surfaceParts(solid.shape())));
  const double u = uniform(random, 0, 1);
  return surfaceSample(solid, part, u, uniform(random, 0, 1));
}

double implicitFunction(const Solid& solid, const glm::dvec3& point) {
  const glm::dvec3 moved = point - solid.placement().translation();
  return std::visit(ImplicitAt{glm::transpose(solid.placement().rotation()) * moved},
                    solid.shape());
}

double volume(const Shape& shape) {
  return std::visit(VolumeOf{}, shape);
}

}  // namespace haarlight::test
