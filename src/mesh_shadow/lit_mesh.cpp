#include "mesh_shadow/lit_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "mesh/occluder.h"
#include "shadow/shaft.h"

namespace haarlight {

namespace {

void checkFinite(const TriangleMesh& mesh) {
  for (const glm::vec3& p : mesh.positions)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError("a mesh must have finite coordinates to take part in shadows");
}

bool hasCorners(const VertexTriple& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

}  // namespace

double singlePrecisionMargin(const AxisBox& box) {
  return box.isEmpty() ? 0 : 0x1p-21 * largestCoordinate(box);
}

LitMesh::LitMesh(const TriangleMesh& mesh, const ShadowLight& light) : light_(light) {
  checkFinite(mesh);
  const WeldedMesh welded = weld(mesh);
  positions_.assign(welded.positions.begin(), welded.positions.end());
  for (const VertexTriple& t : welded.triangles) {
    if (!hasCorners(t)) continue;
    triangles_.push_back(t);
    facing_.push_back(std::int8_t(side(t[0], t[1], t[2])));
    for (const std::uint32_t vertex : t)
      bounds_ = united(bounds_, {positions_[vertex], positions_[vertex]});
  }
  lookAtEdges();
  holdsLight_ = liesOn(mesh, light);
}

TriangleCorners LitMesh::corners(std::uint32_t triangle) const {
  const VertexTriple& t = triangles_[triangle];
  return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
}

glm::dvec3 LitMesh::normalToLight(std::uint32_t triangle) const {
  const TriangleCorners t = corners(triangle);
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(normal);
  if (length == 0) return glm::dvec3(0);
  return (facing(triangle) < 0 ? -1 : 1) / length * normal;
}

glm::dvec3 LitMesh::towardsLight(const glm::dvec3& point) const {
  return segmentToLight(point, light_).direction;
}

/// On which side of the plane through a, b and the light c lies.
int LitMesh::side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if (c == a || c == b) return 0;
  const glm::dvec3 origin = positions_[a];
  const glm::dvec3 normal = glm::cross(positions_[b] - origin, positions_[c] - origin);
  const glm::dvec3 towards = towardsLight(origin);
  const double volume = glm::dot(normal, towards);
  constexpr double rounding = 1e-14;
  const double least = rounding * glm::length(normal) * glm::length(towards);
  return volume > least ? 1 : volume < -least ? -1 : 0;
}

void LitMesh::lookAtEdges() {
  neighbors_.assign(triangles_.size(), {border, border, border});
  const std::vector<EdgeUse> uses = sortedEdgeUses(triangles_);
  forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
    if (isOfSilhouette(edge)) {
      silhouette_.push_back({edge[0].low, edge[0].high});
      silhouetteCorners_.push_back(edge[0].corner);
    }
    for (std::size_t i = 0; i < edge.size() && edge.size() > 1; ++i)
      neighbors_[edge[i].triangle()][edge[i].corner % 3] =
          edge.size() == 2 ? edge[1 - i].triangle() : branch;
    const auto upward = std::ranges::count_if(
        edge, [&](const EdgeUse& use) { return runsUpward(triangles_, use); });
    isClosed_ = isClosed_ && 2 * std::size_t(upward) == edge.size();
  });
}

bool LitMesh::isOfSilhouette(std::span<const EdgeUse> edge) const {
  bool left = false, right = false;
  for (const EdgeUse& use : edge) {
    const int upward = runsUpward(triangles_, use) ? 1 : -1;
    const int side = upward * facing(use.triangle());
    left = left || side > 0, right = right || side < 0;
  }
  return !left || !right;
}

/// Whether all of triangle b lies on the other side than a of an edge of a.
bool LitMesh::hasSeparatingEdge(std::uint32_t a, std::uint32_t b) const {
  const VertexTriple& t = triangles_[a];
  for (int i = 0; i < 3; ++i) {
    bool separates = true;
    for (const std::uint32_t vertex : triangles_[b])
      separates = separates && facing(a) * side(t[i], t[(i + 1) % 3], vertex) <= 0;
    if (separates) return true;
  }
  return false;
}

bool LitMesh::mayOverlap(std::uint32_t a, std::uint32_t b) const {
  if (facing(a) == 0 || facing(b) == 0) return true;
  return !hasSeparatingEdge(a, b) && !hasSeparatingEdge(b, a);
}

bool liesOn(const TriangleMesh& mesh, const ShadowLight& light) {
  const auto* point = std::get_if<PointLight>(&light);
  if (!point) return false;
  const double margin = singlePrecisionMargin(boundsOf(&mesh));
  const AxisBox place{point->position - margin, point->position + margin};
  return std::ranges::any_of(mesh.triangles, [&](const auto& t) {
    const auto corner = [&](int i) { return glm::dvec3(mesh.positions[t[i]]); };
    return triangleMeetsBox({corner(0), corner(1), corner(2)}, place);
  });
}

}  // namespace haarlight
