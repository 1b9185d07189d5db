#include "mesh_shadow/mesh_object.h"

#include <algorithm>
#include <numeric>

#include "mesh_shadow/crossed_triangles.h"
#include "mesh_shadow/edge_shadow.h"
#include "mesh_shadow/hidden_triangles.h"
#include "mesh_shadow/lit_mesh.h"
#include "mesh_shadow/plain_triangles.h"
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
    triangles_.reserve(mesh_.triangleCount());
    for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t)
      triangles_.emplace_back(mesh_.corners(t));
    const auto crossed = findCrossedTriangles(triangles_, mesh_.triangles());
    isPlain_ = findPlainTriangles(mesh_, crossed);
    isHidden_ = findHiddenTriangles(mesh_, crossed);
    for (std::size_t edge = 0; edge < mesh_.silhouette().size(); ++edge) {
      if (isHiddenFold(mesh_, edge, isPlain_, isHidden_)) continue;
      const auto [a, b] = mesh_.silhouette()[edge];
      silhouette_.emplace_back(mesh_.positions()[a], mesh_.positions()[b], light);
    }
  }

  AxisBox bounds() const override { return mesh_.bounds(); }
  double tolerance() const override { return margin_; }

  Parts surfaceParts() const override { return numbers(triangles_.size()); }

  /// Triangles next to the cell count too, as they may matter for the own shadow.
  bool surfaceReaches(const AxisBox& cell, PartView triangles, Parts& kept) const override {
    const std::size_t before = kept.size();
    const AxisBox around = grown(cell, margin_);
    for (const std::uint32_t triangle : triangles)
      if (triangles_[triangle].mayMeet(around)) kept.push_back(triangle);
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
    if (triangles.size() == 1) {
      starts.push_back(ownStart(cell, triangles));
      return;
    }
    const std::size_t before = starts.size();
    std::vector<std::uint8_t> isFound(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (isFound[i]) continue;
      const auto point = pointInBoth(triangles_[triangles[i]].corners, cell);
      if (!point) continue;
      starts.push_back(offSurface({triangles[i], *point}));
      findSheet(cell, triangles, i, isFound);
    }
    if (starts.size() == before) starts.push_back(ownStart(cell, triangles));
  }

  Parts casterParts() const override { return numbers(silhouette_.size() + triangles_.size()); }

  CellShadow shadowOn(const Shaft& shaft, PartView parts, Parts& kept) const override {
    if (shadowOf(bounds(), shaft.cell(), shaft.light()) == BoxShadow::none) return CellShadow::none;
    if (mesh_.holdsLight()) return CellShadow::all;
    const std::size_t before = kept.size();
    const double margin = singlePrecisionMargin(united(bounds(), shaft.cell()));
    const AxisBox cell = grown(shaft.cell(), margin);
    const ShaftView view(shaft, margin + shaft.margin());
    for (const std::uint32_t part : parts)
      if (isEdge(part) ? silhouette_[part].mayReach(view)
                       : triangles_[part - silhouette_.size()].mayMeet(cell))
        kept.push_back(part);
    return kept.size() == before ? CellShadow::uniform : CellShadow::unknown;
  }

  bool castsOnItself() const override { return true; }
  Parts ownCasterParts() const override { return numbers(silhouette_.size()); }

  CellShadow ownShadowOn(const Shaft& shaft, PartView surface, PartView parts,
                         Parts& kept) const override {
    if (mesh_.holdsLight() || areHidden(surface)) return CellShadow::all;
    const std::size_t before = kept.size();
    const ShaftView view(shaft, margin_ + shaft.margin());
    for (const std::uint32_t edge : parts)
      if (silhouette_[edge].mayReach(view)) kept.push_back(edge);
    return kept.size() == before && areSheets(surface) ? CellShadow::uniform : CellShadow::unknown;
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
  /// cell; where it can be, one of which more is asked than whether its triangle is hidden.
  Place place(const AxisBox& cell, PartView triangles) const {
    for (const AxisBox& box : {cell, grown(cell, 2 * margin_)})
      for (const bool hidden : {false, true})
        for (const std::uint32_t triangle : triangles)
          if (bool(isHidden_[triangle]) == hidden)
            if (const auto point = pointInBoth(triangles_[triangle].corners, box))
              return {triangle, *point};
    return {triangles[0], triangles_[triangles[0]].corners[0]};
  }

  /// Off the surface by more than its rounding, so that rays do not meet the triangle that they
  /// start from.
  glm::dvec3 offSurface(const Place& place) const {
    return place.point + 4 * margin_ * mesh_.normalToLight(place.triangle);
  }

  /// Marks the triangles that hang together with one by edges in the cell.
  void findSheet(const AxisBox& cell, PartView triangles, std::size_t first,
                 std::vector<std::uint8_t>& isFound) const {
    std::vector<std::size_t> open{first};
    isFound[first] = 1;
    while (!open.empty()) {
      const std::uint32_t triangle = triangles[open.back()];
      open.pop_back();
      const TriangleCorners& corners = triangles_[triangle].corners;
      for (int i = 0; i < 3; ++i) {
        const auto next = std::ranges::lower_bound(triangles, mesh_.neighbor(triangle, i));
        if (next == triangles.end() || *next != mesh_.neighbor(triangle, i)) continue;
        const auto place = std::size_t(next - triangles.begin());
        if (isFound[place] || !segmentMeetsBox(corners[i], corners[(i + 1) % 3], cell)) continue;
        isFound[place] = 1;
        open.push_back(place);
      }
    }
  }

  bool areHidden(PartView triangles) const {
    return std::ranges::all_of(triangles, [&](std::uint32_t t) { return isHidden_[t] != 0; });
  }

  /// Whether none of the triangles may shadow a point of another, or a point of itself, where no
  /// edge of the silhouette is.
  bool areSheets(PartView triangles) const {
    return std::ranges::all_of(
               triangles, [&](std::uint32_t t) { return isPlain_[t] && mesh_.facing(t) != 0; }) ||
           areApart(triangles);
  }

  /// Whether no two of the triangles may shadow each other.
  bool areApart(PartView triangles) const {
    if (triangles.size() > mostCompared) return false;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (mesh_.mayOverlap(triangles[i], triangles[k])) return false;
    return true;
  }

  LitMesh mesh_;
  double margin_;
  std::vector<EdgeShadow> silhouette_;  ///< but for hidden folds
  std::vector<BoxedTriangle> triangles_;
  std::vector<std::uint8_t> isPlain_, isHidden_;  ///< of triangles
};

}  // namespace

std::unique_ptr<ShadowObject> makeShadowObject(const TriangleMesh& mesh, const ShadowLight& light) {
  return std::make_unique<MeshObject>(mesh, light);
}

}  // namespace haarlight
