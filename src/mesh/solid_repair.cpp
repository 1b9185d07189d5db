#include "mesh/solid_repair.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "mesh/connectivity.h"
#include "mesh/loose_patches.h"
#include "mesh/mesh_measures.h"
#include "mesh/patch_facing.h"
#include "mesh/surface_patches.h"

namespace haarlight {

namespace {

bool hasArea(std::span<const glm::vec3> positions, const VertexTriple& t) {
  return triangleHasArea(positions[t[0]], positions[t[1]], positions[t[2]]);
}

/// Sorts the vertices of a triangle; tells whether that turned it over.
bool sortVertices(VertexTriple& t) {
  bool turned = false;
  const auto order = [&](int i, int j) {
    if (t[i] <= t[j]) return;
    std::swap(t[i], t[j]);
    turned = !turned;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return turned;
}

/// Keeps the items whose flag is not set.
template <typename Item>
void eraseFlagged(std::vector<Item>& items, std::span<const std::uint8_t> flags) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!flags[i]) items[kept++] = items[i];
  items.resize(kept);
}

/// The triangles have sorted vertices from weld to orient, so that nothing there depends on which
/// way they face in the input.
class SolidMaker {
 public:
  explicit SolidMaker(const TriangleMesh& mesh) {
    WeldedMesh welded = weld(mesh);
    positions_ = std::move(welded.positions);
    triangles_ = std::move(welded.triangles);
    result_.joinedVertices = mesh.positions.size() - positions_.size();
  }

  SolidRepair run() {
    asInput_.reserve(triangles_.size());
    for (VertexTriple& t : triangles_) asInput_.push_back(!sortVertices(t));
    leaveOutDegenerate();
    leaveOutDuplicates();
    leaveOutLoosePatches();
    orient();
    build();
    addWarnings();
    return std::move(result_);
  }

 private:
  std::size_t leaveOut(std::span<const std::uint8_t> flags) {
    const std::size_t before = triangles_.size();
    eraseFlagged(triangles_, flags);
    eraseFlagged(asInput_, flags);
    if (!doubled_.empty()) eraseFlagged(doubled_, flags);
    return before - triangles_.size();
  }

  void leaveOutDegenerate() {
    std::vector<std::uint8_t> degenerate;
    degenerate.reserve(triangles_.size());
    for (const VertexTriple& t : triangles_) degenerate.push_back(!hasArea(positions_, t));
    result_.degenerateTriangles = leaveOut(degenerate);
  }

  void leaveOutDuplicates() {
    std::vector<std::pair<VertexTriple, std::uint32_t>> sorted;
    sorted.reserve(triangles_.size());
    for (const VertexTriple& t : triangles_)
      sorted.emplace_back(t, static_cast<std::uint32_t>(sorted.size()));
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint8_t> duplicate(triangles_.size());
    doubled_.resize(triangles_.size());
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const bool repeats = i > 0 && sorted[i].first == sorted[i - 1].first;
      if (!repeats) first = sorted[i].second;
      duplicate[sorted[i].second] = repeats;
      doubled_[first] ^= repeats;
    }
    result_.duplicateTriangles = leaveOut(duplicate);
  }

  void leaveOutLoosePatches() {
    edges_ = sortedEdgeUses(triangles_);
    patches_ = surfacePatches(triangles_, edges_);
    const LoosePatches loose{positions_, triangles_, edges_, patches_};
    const auto flag = [&](const std::vector<std::uint8_t>& chosen) {
      std::vector<std::uint8_t> flags;
      flags.reserve(triangles_.size());
      for (const std::uint32_t patch : patches_.patchOf) flags.push_back(chosen[patch]);
      return flags;
    };
    const auto stray = flag(loose.stray());
    auto wall = flag(loose.walls(doubled_));
    eraseFlagged(wall, stray);
    result_.strayTriangles = leaveOut(stray);
    result_.wallTriangles = leaveOut(wall);
    if (result_.strayTriangles + result_.wallTriangles > 0) {
      edges_ = sortedEdgeUses(triangles_);
      patches_ = surfacePatches(triangles_, edges_);
    }
  }

  void turn(std::size_t triangle) {
    std::swap(triangles_[triangle][1], triangles_[triangle][2]);
    asInput_[triangle] ^= 1;
  }

  void orient() {
    edges_ = {};
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (patches_.turned[i]) turn(i);
    const PatchFacing facing = facePatches(positions_, triangles_, asInput_, patches_);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (facing.turn[patches_.patchOf[i]]) turn(i);
    result_.turnedTriangles = facing.turnedTriangles;
    result_.turnedParts = facing.turnedPatches;
  }

  void build() {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(positions_.size(), none);
    for (const VertexTriple& t : triangles_) {
      VertexTriple sorted = t;
      std::sort(sorted.begin(), sorted.end());
      for (const std::uint32_t vertex : sorted) {
        if (number[vertex] != none) continue;
        number[vertex] = static_cast<std::uint32_t>(result_.mesh.positions.size());
        result_.mesh.positions.push_back(positions_[vertex]);
      }
      VertexTriple numbered = {number[t[0]], number[t[1]], number[t[2]]};
      std::rotate(numbered.begin(), std::min_element(numbered.begin(), numbered.end()),
                  numbered.end());
      result_.mesh.triangles.emplace_back(numbered[0], numbered[1], numbered[2]);
    }
    result_.unusedVertices = positions_.size() - result_.mesh.positions.size();
  }

  void warn(const std::string& done, std::size_t count, const std::string& thing,
            const std::string& why) {
    if (count > 0)
      result_.warnings.push_back(done + " " + std::to_string(count) + " " + thing +
                                 (count > 1 ? "s" : "") + why);
  }

  void addWarnings() {
    warn("left out", result_.degenerateTriangles, "triangle", " without area");
    warn("left out", result_.duplicateTriangles, "duplicate triangle", "");
    warn("left out", result_.wallTriangles, "triangle", " between touching solids");
    warn("left out", result_.strayTriangles, "stray triangle", "");
    warn("turned", result_.turnedTriangles, "triangle", " so that neighbours agree");
    warn("turned", result_.turnedParts, "part", " of the surface that faced inwards");
  }

  std::vector<glm::vec3> positions_;
  std::vector<VertexTriple> triangles_;
  std::vector<std::uint8_t> asInput_;  ///< by triangle: faces as it did in the input
  std::vector<std::uint8_t> doubled_;  ///< by triangle: was there an even number of times
  std::vector<EdgeUse> edges_;
  SurfacePatches patches_;
  SolidRepair result_;
};

}  // namespace

SolidRepair prepareSolid(const TriangleMesh& mesh) {
  return SolidMaker(mesh).run();
}

}  // namespace haarlight
