#include "mesh_shadow/mesh_object.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "mesh_shadow/lit_mesh.h"
#include "mesh_shadow/triangle_box.h"
#include "shadow/box_shadow.h"
#include "shadow/convex_gap.h"

namespace haarlight {

namespace {

/// More triangles in one cell are not compared with each other.
constexpr std::size_t mostCompared = 12;

AxisBox grown(const AxisBox& box, double margin) {
  return {box.lower - margin, box.upper + margin};
}

class MeshObject final : public ShadowObject {
 public:
  MeshObject(const TriangleMesh& mesh, const ShadowLight& light)
      : mesh_(mesh, light),
        margin_(singlePrecisionMargin(mesh_.bounds())),
        edgeCount_(std::uint32_t(mesh_.silhouette().size())) {}

  AxisBox bounds() const override { return mesh_.bounds(); }
  double tolerance() const override { return margin_; }

  Parts surfaceParts() const override { return numbers(mesh_.triangleCount()); }

  bool surfaceReaches(const AxisBox& cell, Parts& triangles) const override {
    std::erase_if(triangles, [&](std::uint32_t t) { return !meets(t, cell); });
    return !triangles.empty();
  }

  glm::dvec3 surfacePoint(const AxisBox& cell, const Parts& triangles) const override {
    for (const std::uint32_t triangle : triangles)
      if (const auto point = pointInBoth(mesh_.corners(triangle), cell)) return *point;
    return glm::clamp(mesh_.corners(triangles[0])[0], cell.lower, cell.upper);
  }

  /// Off the surface by more than its rounding, so that rays do not meet the triangle that they
  /// start from.
  std::vector<glm::dvec3> ownPoints(const AxisBox& cell, const Parts& triangles) const override {
    std::vector<glm::dvec3> result;
    for (const std::uint32_t triangle : triangles)
      if (const auto point = pointInBoth(mesh_.corners(triangle), cell))
        result.push_back(*point + 4 * margin_ * mesh_.normalToLight(triangle));
    if (result.empty()) result.push_back(surfacePoint(cell, triangles));
    return result;
  }

  Parts casterParts() const override { return numbers(edgeCount_ + mesh_.triangleCount()); }

  CellShadow shadowOn(const Shaft& shaft, Parts& parts) const override {
    if (shadowOf(bounds(), shaft.cell(), shaft.light()) == BoxShadow::none) return CellShadow::none;
    if (mesh_.holdsLight()) return CellShadow::all;
    keepNear(shaft, parts);
    return parts.empty() ? CellShadow::uniform : CellShadow::unknown;
  }

  bool castsOnItself() const override { return true; }

  CellShadow ownShadowOn(const Shaft& shaft, Parts& parts) const override {
    if (mesh_.holdsLight()) return CellShadow::all;
    keepNear(shaft, parts);
    return isOneSheet(parts) ? CellShadow::uniform : CellShadow::unknown;
  }

 private:
  static Parts numbers(std::size_t count) {
    Parts result(count);
    std::iota(result.begin(), result.end(), 0u);
    return result;
  }

  bool meets(std::uint32_t triangle, const AxisBox& box) const {
    return triangleMeetsBox(mesh_.corners(triangle), box);
  }

  /// Leaves the edges of the silhouette that may meet the shaft, and the triangles that may meet
  /// the cell; in that order, as before.
  void keepNear(const Shaft& shaft, Parts& parts) const {
    const double margin = singlePrecisionMargin(united(bounds(), shaft.cell()));
    const AxisBox cell = grown(shaft.cell(), margin);
    std::erase_if(parts, [&](std::uint32_t part) {
      return part < edgeCount_ ? !edgeMeets(shaft, part, margin) : !meets(part - edgeCount_, cell);
    });
  }

  bool edgeMeets(const Shaft& shaft, std::uint32_t edge, double margin) const {
    const glm::dvec3 a = mesh_.positions()[mesh_.silhouette()[edge][0]];
    const glm::dvec3 b = mesh_.positions()[mesh_.silhouette()[edge][1]];
    const AxisBox box = grown({glm::min(a, b), glm::max(a, b)}, margin);
    if (shadowOf(box, shaft.cell(), shaft.light()) == BoxShadow::none) return false;
    const auto ends = [&](const glm::dvec3& n) { return glm::dot(b - a, n) > 0 ? b : a; };
    const auto way = [&](const glm::dvec3& n) { return shaft.support(n); };
    return !gapBetween(ends, way, 0.5 * (a + b) - shaft.center(), margin + shaft.margin()).isApart;
  }

  /// Whether no edge of the silhouette is left, and no two of the triangles may shadow each other.
  bool isOneSheet(const Parts& parts) const {
    if (parts.size() > mostCompared || (!parts.empty() && parts.front() < edgeCount_)) return false;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (mesh_.mayOverlap(parts[i] - edgeCount_, parts[k] - edgeCount_)) return false;
    return true;
  }

  LitMesh mesh_;
  double margin_;
  std::uint32_t edgeCount_;
};

}  // namespace

std::unique_ptr<ShadowObject> makeShadowObject(const TriangleMesh& mesh, const ShadowLight& light) {
  return std::make_unique<MeshObject>(mesh, light);
}

}  // namespace haarlight
