#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/connectivity.h"
#include "mesh/triangle_mesh.h"
#include "mesh_shadow/triangle_box.h"
#include "shadow/shadow_light.h"

namespace haarlight {

/// A mesh as a light sees it. Nothing is asked of the mesh but finite coordinates: it may be open,
/// turned at will, and any number of triangles may share an edge.
class LitMesh {
 public:
  using Edge = std::array<std::uint32_t, 2>;
  static constexpr std::uint32_t border = ~std::uint32_t(0), branch = border - 1;

  /// Vertices at one position become one. Throws InputError when a coordinate is not finite.
  LitMesh(const TriangleMesh& mesh, const ShadowLight& light);

  const ShadowLight& light() const { return light_; }
  const std::vector<glm::dvec3>& positions() const { return positions_; }
  const std::vector<VertexTriple>& triangles() const { return triangles_; }
  std::size_t triangleCount() const { return triangles_.size(); }
  TriangleCorners corners(std::uint32_t triangle) const;
  const AxisBox& bounds() const { return bounds_; }

  /// 1 where the light sees the side from which the corners run counter-clockwise, −1 where it sees
  /// the other one, 0 where it sees the triangle edge-on, as far as rounding can tell.
  int facing(std::uint32_t triangle) const { return facing_[triangle]; }
  /// Unit, towards the side that the light sees; zero for a triangle without an area.
  glm::dvec3 normalToLight(std::uint32_t triangle) const;

  /// The edges at which the mesh may end, as seen from the light: all but those that have triangles
  /// on both sides.
  const std::vector<Edge>& silhouette() const { return silhouette_; }
  /// For each of these, one of its uses: 3 · triangle + the corner that it starts from.
  const std::vector<std::uint32_t>& silhouetteCorners() const { return silhouetteCorners_; }

  /// The triangle at the other side of the edge from a corner to the next; `border` if there is
  /// none, `branch` if there are several.
  std::uint32_t neighbor(std::uint32_t triangle, int corner) const {
    return neighbors_[triangle][std::size_t(corner)];
  }

  bool isTriangle(std::uint32_t neighbor) const { return neighbor < triangleCount(); }

  /// Whether triangles run through every edge as often upwards as downwards, so that they bound
  /// spaces: every point off the mesh has a winding number.
  bool isClosed() const { return isClosed_; }

  /// Whether the light may see one triangle through the other: not where a plane through the light
  /// and an edge has them on different sides.
  bool mayOverlap(std::uint32_t a, std::uint32_t b) const;

  /// As liesOn.
  bool holdsLight() const { return holdsLight_; }

  /// Of any length.
  glm::dvec3 towardsLight(const glm::dvec3& point) const;

 private:
  int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  bool hasSeparatingEdge(std::uint32_t a, std::uint32_t b) const;
  void lookAtEdges();
  bool isOfSilhouette(std::span<const EdgeUse> edge) const;

  ShadowLight light_;
  std::vector<glm::dvec3> positions_;
  std::vector<VertexTriple> triangles_;
  std::vector<std::int8_t> facing_;
  std::vector<Edge> silhouette_;
  std::vector<std::uint32_t> silhouetteCorners_;
  std::vector<VertexTriple> neighbors_;
  AxisBox bounds_;
  bool holdsLight_ = false, isClosed_ = true;
};

/// Whether a light lies on a mesh, as far as the coordinates' rounding can tell.
bool liesOn(const TriangleMesh& mesh, const ShadowLight& light);

/// How far rounding to single precision may move a point within a box.
double singlePrecisionMargin(const AxisBox& box);

}  // namespace haarlight
