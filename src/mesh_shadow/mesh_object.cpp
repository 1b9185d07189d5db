#include "mesh_shadow/mesh_object.h"

#include <numeric>

#include "mesh_shadow/edge_shadow.h"
#include "mesh_shadow/lit_mesh.h"
#include "mesh_shadow/triangle_box.h"
#include "shadow/box_shadow.h"

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
      : mesh_(mesh, light), margin_(singlePrecisionMargin(mesh_.bounds())) {
    for (const auto& [a, b] : mesh_.silhouette())
      silhouette_.emplace_back(mesh_.positions()[a], mesh_.positions()[b], light);
    for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t)
      triangles_.emplace_back(mesh_.corners(t));
  }

  AxisBox bounds() const override { return mesh_.bounds(); }
  double tolerance() const override { return margin_; }

  Parts surfaceParts() const override { return numbers(triangles_.size()); }

  /// Triangles next to the cell count too, as they may matter for the own shadow.
  bool surfaceReaches(const AxisBox& cell, PartView triangles, Parts& kept) const override {
    const std::size_t before = kept.size();
    const AxisBox around = grown(cell, margin_);
    for (const std::uint32_t triangle : triangles)
      if (triangles_[triangle].meets(around)) kept.push_back(triangle);
    return kept.size() > before;
  }

  glm::dvec3 surfacePoint(const AxisBox& cell, PartView triangles) const override {
    return place(cell, triangles).point;
  }

  glm::dvec3 ownStart(const AxisBox& cell, PartView triangles) const override {
    return offSurface(place(cell, triangles));
  }

  void addOwnStarts(const AxisBox& cell, PartView triangles,
                    std::vector<glm::dvec3>& starts) const override {
    const std::size_t before = starts.size();
    for (const std::uint32_t triangle : triangles)
      if (const auto point = pointInBoth(triangles_[triangle].corners, cell))
        starts.push_back(offSurface({triangle, *point}));
    if (starts.size() == before) starts.push_back(ownStart(cell, triangles));
  }

  Parts casterParts() const override { return numbers(silhouette_.size() + triangles_.size()); }

  CellShadow shadowOn(const Shaft& shaft, PartView parts, Parts& kept) const override {
    if (shadowOf(bounds(), shaft.cell(), shaft.light()) == BoxShadow::none) return CellShadow::none;
    if (mesh_.holdsLight()) return CellShadow::all;
    const std::size_t before = kept.size();
    const double margin = singlePrecisionMargin(united(bounds(), shaft.cell()));
    const AxisBox cell = grown(shaft.cell(), margin);
    for (const std::uint32_t part : parts)
      if (isEdge(part) ? silhouette_[part].mayReach(shaft, margin + shaft.margin())
                       : triangles_[part - silhouette_.size()].meets(cell))
        kept.push_back(part);
    return kept.size() == before ? CellShadow::uniform : CellShadow::unknown;
  }

  bool castsOnItself() const override { return true; }
  Parts ownCasterParts() const override { return numbers(silhouette_.size()); }

  CellShadow ownShadowOn(const Shaft& shaft, PartView surface, PartView parts,
                         Parts& kept) const override {
    if (mesh_.holdsLight()) return CellShadow::all;
    const std::size_t before = kept.size();
    for (const std::uint32_t edge : parts)
      if (silhouette_[edge].mayReach(shaft, margin_ + shaft.margin())) kept.push_back(edge);
    return kept.size() == before && isOneSheet(surface) ? CellShadow::uniform : CellShadow::unknown;
  }

 private:
  struct Place {
    std::uint32_t triangle;
    glm::dvec3 point;
  };

  static Parts numbers(std::size_t count) {
    Parts result(count);
    std::iota(result.begin(), result.end(), 0u);
    return result;
  }

  /// Parts are the silhouette's edges, then the triangles.
  bool isEdge(std::uint32_t part) const { return part < silhouette_.size(); }

  /// A point of the surface in the cell, or next to it where only the margin makes it reach the
  /// cell.
  Place place(const AxisBox& cell, PartView triangles) const {
    for (const AxisBox& box : {cell, grown(cell, 2 * margin_)})
      for (const std::uint32_t triangle : triangles)
        if (const auto point = pointInBoth(triangles_[triangle].corners, box))
          return {triangle, *point};
    return {triangles[0], triangles_[triangles[0]].corners[0]};
  }

  /// Off the surface by more than its rounding, so that rays do not meet the triangle that they
  /// start from.
  glm::dvec3 offSurface(const Place& place) const {
    return place.point + 4 * margin_ * mesh_.normalToLight(place.triangle);
  }

  /// Whether no two of the triangles may shadow each other.
  bool isOneSheet(PartView triangles) const {
    if (triangles.size() > mostCompared) return false;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (mesh_.mayOverlap(triangles[i], triangles[k])) return false;
    return true;
  }

  LitMesh mesh_;
  double margin_;
  std::vector<EdgeShadow> silhouette_;
  std::vector<BoxedTriangle> triangles_;
};

}  // namespace

std::unique_ptr<ShadowObject> makeShadowObject(const TriangleMesh& mesh, const ShadowLight& light) {
  return std::make_unique<MeshObject>(mesh, light);
}

}  // namespace haarlight
