#include "mesh/builtin_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "base/error.h"

namespace haarlight {

namespace {

const std::map<std::string, std::function<TriangleMesh()>> builtinMeshes = {
    {"builtin:sphere", [] { return icosphere(4); }},
    {"builtin:torusknot", [] { return torusKnot(); }}};

/// Point of the knot, direction of the curve, and the torus's normal there. The curve lies on the
/// torus, so its normal is perpendicular to the curve and closes up smoothly, other than a frame
/// carried along the curve.
struct KnotFrame {
  glm::dvec3 point, tangent, normal;
};

KnotFrame knotFrame(const TorusKnot& shape, double angle) {
  const double around = shape.p * angle, tube = shape.q * angle;
  const glm::dvec3 outward(std::cos(around), 0, std::sin(around));
  const glm::dvec3 forward(-std::sin(around), 0, std::cos(around));
  const glm::dvec3 up(0, 1, 0);
  const double radius = 2 + std::cos(tube);
  KnotFrame frame;
  frame.point = radius * outward + std::sin(tube) * up;
  frame.tangent =
      glm::normalize(shape.p * radius * forward +
                     double(shape.q) * (std::cos(tube) * up - std::sin(tube) * outward));
  frame.normal = std::cos(tube) * outward + std::sin(tube) * up;
  return frame;
}

/// Triangles of a grid of points, facing the side from which `columns` runs counter-clockwise
/// ahead of `rows`; each direction may close up on itself. The diagonals alternate, as equal ones
/// would bulge a twisted tube outwards or inwards everywhere.
std::vector<glm::uvec3> gridTriangles(int rowCells, int columnCells, bool closed) {
  const int rows = closed ? rowCells : rowCells + 1;
  const int columns = closed ? columnCells : columnCells + 1;
  const auto vertex = [&](int row, int column) {
    return static_cast<std::uint32_t>(row % rows * columns + column % columns);
  };
  std::vector<glm::uvec3> triangles;
  for (int row = 0; row < rowCells; ++row)
    for (int column = 0; column < columnCells; ++column) {
      const std::uint32_t a = vertex(row, column), b = vertex(row, column + 1);
      const std::uint32_t c = vertex(row + 1, column + 1), d = vertex(row + 1, column);
      const bool fromFirst = (row + column) % 2 == 0;
      triangles.emplace_back(a, b, fromFirst ? c : d);
      triangles.emplace_back(fromFirst ? a : b, c, d);
    }
  return triangles;
}

TriangleMesh icosahedron() {
  const float golden = std::numbers::phi_v<float>;
  TriangleMesh mesh;
  for (const float one : {-1.0f, 1.0f})
    for (const float g : {-golden, golden}) {
      mesh.positions.emplace_back(0, one, g);
      mesh.positions.emplace_back(one, g, 0);
      mesh.positions.emplace_back(g, 0, one);
    }
  // Faces are the triples of vertices at the edge length, 2.
  const auto adjacent = [&](std::uint32_t a, std::uint32_t b) {
    return glm::distance(mesh.positions[a], mesh.positions[b]) < 2.1f;
  };
  for (std::uint32_t a = 0; a < 12; ++a)
    for (std::uint32_t b = a + 1; b < 12; ++b)
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(c, a)) continue;
        const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
        const bool outward = glm::dot(glm::cross(q - p, r - p), p) > 0;
        mesh.triangles.push_back(outward ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b));
      }
  for (auto& position : mesh.positions) position = glm::normalize(position);
  return mesh;
}

void subdivideSphere(TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
    if (isNew)
      mesh.positions.push_back(
          glm::vec3(glm::normalize(glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b]))));
    return entry->second;
  };
  std::vector<glm::uvec3> triangles;
  for (const glm::uvec3& t : mesh.triangles) {
    const std::uint32_t a = middle(t.y, t.z), b = middle(t.z, t.x), c = middle(t.x, t.y);
    for (const glm::uvec3& part :
         {glm::uvec3(t.x, c, b), glm::uvec3(c, t.y, a), glm::uvec3(b, a, t.z), glm::uvec3(a, b, c)})
      triangles.push_back(part);
  }
  mesh.triangles = std::move(triangles);
}

}  // namespace

TriangleMesh torusKnot(const TorusKnot& shape) {
  TriangleMesh mesh;
  const double turn = 2 * std::numbers::pi;
  std::vector<glm::dvec3> points;
  double largest = 0;
  for (int i = 0; i < shape.lengthSegments; ++i) {
    const KnotFrame frame = knotFrame(shape, turn * i / shape.lengthSegments);
    const glm::dvec3 side = glm::cross(frame.tangent, frame.normal);
    for (int j = 0; j < shape.tubeSegments; ++j) {
      const double angle = turn * j / shape.tubeSegments;
      const glm::dvec3 normal = std::cos(angle) * frame.normal + std::sin(angle) * side;
      points.push_back(frame.point + shape.tubeRadius * normal);
      mesh.normals.emplace_back(normal);
      largest = std::max(largest, glm::length(points.back()));
    }
  }
  for (const glm::dvec3& point : points) mesh.positions.emplace_back(point / largest);
  mesh.triangles = gridTriangles(shape.lengthSegments, shape.tubeSegments, true);
  return mesh;
}

TriangleMesh icosphere(int subdivisions) {
  TriangleMesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i) subdivideSphere(mesh);
  mesh.normals = mesh.positions;
  return mesh;
}

TriangleMesh groundGrid(float halfExtent, int cells) {
  TriangleMesh mesh;
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column)
      mesh.positions.emplace_back(halfExtent * (2.0f * float(row) / float(cells) - 1), 0,
                                  halfExtent * (2.0f * float(column) / float(cells) - 1));
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
  mesh.triangles = gridTriangles(cells, cells, false);
  return mesh;
}

std::vector<std::string> builtinMeshNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : builtinMeshes) names.push_back(name);
  return names;
}

TriangleMesh builtinMesh(const std::string& name) {
  const auto found = builtinMeshes.find(name);
  if (found != builtinMeshes.end()) return found->second();
  std::string known;
  for (const auto& other : builtinMeshNames()) known += (known.empty() ? "" : ", ") + other;
  throw InputError("there is no built-in mesh '" + name + "'; choose one of " + known);
}

}  // namespace haarlight
