#include "mesh/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "solids/shape_geometry.h"
#include "solids/solid_checks.h"

namespace haarlight {

namespace {

/// Cosine and sine of the part i / n of a turn; exact at quarter turns, so that poles and seams are
/// single points.
glm::dvec2 onCircle(int i, int n) {
  constexpr glm::dvec2 quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  i %= n;
  if (4 * i % n == 0) return quarters[4 * i / n];
  const double angle = 2 * std::numbers::pi * i / n;
  return {std::cos(angle), std::sin(angle)};
}

/// A point of the outline that turns around the y axis: (distance from the axis, y).
struct OutlinePoint {
  glm::dvec2 position, normal;
};
using Outline = std::vector<OutlinePoint>;

glm::dvec3 turned(const glm::dvec2& point, const glm::dvec2& around) {
  return {point.x * around.x, point.y, -point.x * around.y};
}

/// Leaves out triangles that a pole has made a line.
void addTriangle(TriangleMesh& mesh, const glm::uvec3& triangle) {
  const auto at = [&](int corner) { return mesh.positions[triangle[corner]]; };
  if (at(0) != at(1) && at(1) != at(2) && at(2) != at(0)) mesh.triangles.push_back(triangle);
}

/// Turned around the axis, which is on the outline's left hand, then stretched.
void addTurned(TriangleMesh& mesh, const Outline& outline, int segments,
               const glm::dvec3& stretch = glm::dvec3(1)) {
  const auto first = std::uint32_t(mesh.positions.size());
  for (const OutlinePoint& point : outline)
    for (int i = 0; i < segments; ++i) {
      const glm::dvec2 around = onCircle(i, segments);
      mesh.positions.emplace_back(stretch * turned(point.position, around));
      mesh.normals.emplace_back(glm::normalize(turned(point.normal, around) / stretch));
    }
  const auto vertex = [&](std::size_t row, int column) {
    return first + std::uint32_t(row * segments + column % segments);
  };
  for (std::size_t row = 0; row + 1 < outline.size(); ++row)
    for (int i = 0; i < segments; ++i) {
      addTriangle(mesh, {vertex(row, i), vertex(row, i + 1), vertex(row + 1, i + 1)});
      addTriangle(mesh, {vertex(row, i), vertex(row + 1, i + 1), vertex(row + 1, i)});
    }
}

TriangleMesh polygons(const EllipsoidShape& shape, int segments) {
  const int rows = std::max(2, segments / 2);
  Outline halfCircle;
  for (int row = 0; row <= rows; ++row) {
    const glm::dvec2 fromBottom = onCircle(row, 2 * rows), point(fromBottom.y, -fromBottom.x);
    halfCircle.push_back({point, point});
  }
  TriangleMesh mesh;
  addTurned(mesh, halfCircle, segments, shape.radii);
  return mesh;
}

TriangleMesh polygons(const ConeShape& shape, int segments) {
  const glm::dvec2 bottom(shape.radius, -shape.height / 2), top(shape.topRadius, shape.height / 2);
  const glm::dvec2 side = glm::normalize(top - bottom), outwards(side.y, -side.x);
  TriangleMesh mesh;
  addTurned(mesh, {{{0, bottom.y}, {0, -1}}, {bottom, {0, -1}}}, segments);
  addTurned(mesh, {{bottom, outwards}, {top, outwards}}, segments);
  addTurned(mesh, {{top, {0, 1}}, {{0, top.y}, {0, 1}}}, segments);
  return mesh;
}

TriangleMesh polygons(const TorusShape& shape, int segments) {
  const int rows = 2 * std::max(2, segments / 4);  // even: one row is nearest to the axis
  Outline tube;
  for (int row = 0; row <= rows; ++row) {
    const glm::dvec2 normal = onCircle(row, rows);
    tube.push_back({glm::dvec2(shape.majorRadius, 0) + shape.minorRadius * normal, normal});
  }
  TriangleMesh mesh;
  addTurned(mesh, tube, segments);
  return mesh;
}

TriangleMesh polygons(const BoxShape& shape, int) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto first = std::uint32_t(mesh.positions.size());
      for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        glm::dvec3 signs, normal(0);
        signs[axis] = normal[axis] = side;
        signs[(axis + 1) % 3] = side * corner.x;  // turned round on the negative side
        signs[(axis + 2) % 3] = corner.y;
        mesh.positions.emplace_back(signs * shape.halfSizes);
        mesh.normals.emplace_back(normal);
      }
      mesh.triangles.push_back(first + glm::uvec3(0, 1, 2));
      mesh.triangles.push_back(first + glm::uvec3(0, 2, 3));
    }
  return mesh;
}

}  // namespace

TriangleMesh solidMesh(const Shape& shape, int segments) {
  checkShape(shape);
  if (segments < 3) throw std::invalid_argument("a solid's polygons need three segments or more");
  return std::visit([&](const auto& s) { return polygons(surfaceOf(s), segments); }, shape);
}

}  // namespace haarlight
