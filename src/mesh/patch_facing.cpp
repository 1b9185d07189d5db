#include "mesh/patch_facing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <memory>
#include <numeric>

#include "mesh/winding_number.h"

namespace haarlight {

namespace {

/// What decides how a patch faces; volumes and areas as its triangles stand.
struct Patch {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};
  glm::dvec3 vectorArea{0};
  double area = 0;
  double volume = 0;  ///< with the centre of its box as apex
  double vote = 0;    ///< area that faces as in the input less area that does not

  glm::dvec3 center() const { return (lower + upper) / 2.0; }
  bool faced() const { return vote >= 0; }  ///< most of it as in the input

  /// Whether the volume has the same sign for every apex in the box: an apex moved by d changes it
  /// by d · vectorArea / 3. A margin is left for rounding.
  bool bounds() const {
    const double reach = glm::length(upper - lower) / 2;
    return std::abs(volume) > reach * (glm::length(vectorArea) / 3 + 1e-9 * area);
  }

  /// +1 when clearly outwards in the input, -1 inwards, 0 when unclear.
  int inputSense() const {
    if (std::abs(vote) < area / 2) return 0;
    return faced() == (volume > 0) ? 1 : -1;
  }

  bool boxContains(const Patch& other) const {
    return glm::all(glm::lessThanEqual(lower, other.lower)) &&
           glm::all(glm::greaterThanEqual(upper, other.upper));
  }
};

class Facing {
 public:
  Facing(std::span<const glm::vec3> positions, std::span<const VertexTriple> triangles,
         std::span<const std::uint8_t> asInput, const SurfacePatches& surface)
      : positions_(positions), triangles_(triangles), surface_(surface), patches_(surface.count) {
    measure(asInput);
    facing_.turn.resize(surface.count);
  }

  PatchFacing run(std::span<const std::uint8_t> asInput) {
    faceBounding();
    facePieces();
    for (std::size_t i = 0; i < patches_.size(); ++i)
      facing_.turnedPatches += (facing_.turn[i] == 0) != patches_[i].faced();
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      facing_.turnedTriangles += (asInput[i] != 0) != patches_[surface_.patchOf[i]].faced();
    return std::move(facing_);
  }

 private:
  void measure(std::span<const std::uint8_t> asInput) {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (const std::uint32_t vertex : triangles_[i]) {
        Patch& patch = patches_[surface_.patchOf[i]];
        patch.lower = glm::min(patch.lower, glm::dvec3(positions_[vertex]));
        patch.upper = glm::max(patch.upper, glm::dvec3(positions_[vertex]));
      }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      Patch& patch = patches_[surface_.patchOf[i]];
      const auto& t = triangles_[i];
      const glm::dvec3 center = patch.center(), a = glm::dvec3(positions_[t[0]]) - center,
                       b = glm::dvec3(positions_[t[1]]) - center,
                       c = glm::dvec3(positions_[t[2]]) - center;
      const glm::dvec3 vectorArea = glm::cross(b - a, c - a) / 2.0;
      patch.vectorArea += vectorArea;
      patch.volume += glm::dot(a, vectorArea) / 3;
      patch.area += glm::length(vectorArea);
      patch.vote += (asInput[i] ? 1 : -1) * glm::length(vectorArea);
    }
  }

  /// The patches that enclose something on their own: outwards, or inwards round a cavity.
  void faceBounding() {
    std::vector<std::uint32_t> bounding;
    for (std::uint32_t i = 0; i < patches_.size(); ++i)
      if (patches_[i].bounds()) bounding.push_back(i);
    std::stable_sort(bounding.begin(), bounding.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::abs(patches_[a].volume) > std::abs(patches_[b].volume);
    });
    const auto faces = [&](int sense) {
      return std::any_of(bounding.begin(), bounding.end(),
                         [&](std::uint32_t i) { return patches_[i].inputSense() == sense; });
    };
    const bool mayHaveCavities = faces(1) && faces(-1);
    for (std::size_t k = 0; k < bounding.size(); ++k) {
      const std::uint32_t patch = bounding[k];
      const bool inwards = mayHaveCavities && isCavity(patch, std::span(bounding).subspan(0, k));
      facing_.turn[patch] = (patches_[patch].volume > 0) == inwards;
    }
  }

  /// Whether the patch faces opposite to the outermost one round it.
  bool isCavity(std::uint32_t patch, std::span<const std::uint32_t> larger) {
    const int sense = patches_[patch].inputSense();
    if (sense == 0) return false;
    for (const std::uint32_t other : larger)
      if (patches_[other].boxContains(patches_[patch]) && isInside(patch, other))
        return patches_[other].inputSense() == -sense;
    return false;
  }

  /// Whether nine tenths of some vertices of one patch lie inside the other, which may have holes.
  bool isInside(std::uint32_t patch, std::uint32_t other) {
    constexpr std::size_t samples = 20;
    if (windingNumbers_.empty()) groupTriangles();
    auto& windingNumber = windingNumbers_[other];
    if (!windingNumber) windingNumber = std::make_unique<WindingNumber>(meshOf(other));
    const auto own = trianglesOf(patch);
    std::size_t inside = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      const VertexTriple& t = triangles_[own[k * own.size() / samples]];
      inside += std::abs((*windingNumber)(positions_[t[k % 3]])) > 0.5f;
    }
    return 10 * inside >= 9 * samples;
  }

  void groupTriangles() {
    windingNumbers_.resize(patches_.size());
    patchBegin_.resize(patches_.size() + 1);
    for (const std::uint32_t patch : surface_.patchOf) ++patchBegin_[patch + 1];
    std::partial_sum(patchBegin_.begin(), patchBegin_.end(), patchBegin_.begin());
    byPatch_.resize(triangles_.size());
    std::vector<std::uint32_t> next(patchBegin_.begin(), patchBegin_.end() - 1);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) byPatch_[next[surface_.patchOf[i]]++] = i;
  }

  std::span<const std::uint32_t> trianglesOf(std::uint32_t patch) const {
    return std::span(byPatch_).subspan(patchBegin_[patch],
                                       patchBegin_[patch + 1] - patchBegin_[patch]);
  }

  TriangleMesh meshOf(std::uint32_t patch) const {
    TriangleMesh mesh;
    for (const std::uint32_t i : trianglesOf(patch)) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const std::uint32_t vertex : triangles_[i]) mesh.positions.push_back(positions_[vertex]);
      mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
  }

  /// The patches that may be pieces of one surface.
  void facePieces() {
    glm::dvec3 lower = patches_[0].lower, upper = patches_[0].upper;
    for (const Patch& patch : patches_) {
      lower = glm::min(lower, patch.lower);
      upper = glm::max(upper, patch.upper);
    }
    const glm::dvec3 apex = (lower + upper) / 2.0;
    double kept = 0, volume = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const Patch& patch = patches_[i];
      if (patch.bounds())
        kept += ((facing_.turn[i] == 0) == patch.faced() ? 1 : -1) * patch.area;
      else
        volume += (patch.faced() ? 1 : -1) *
                  (patch.volume + glm::dot(patch.center() - apex, patch.vectorArea) / 3);
    }
    const bool over = kept != 0 ? kept < 0 : volume < 0;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (!patches_[i].bounds()) facing_.turn[i] = patches_[i].faced() == over;
  }

  std::span<const glm::vec3> positions_;
  std::span<const VertexTriple> triangles_;
  const SurfacePatches& surface_;
  std::vector<Patch> patches_;
  PatchFacing facing_;
  std::vector<std::unique_ptr<WindingNumber>> windingNumbers_;  ///< by patch, made when needed
  std::vector<std::uint32_t> byPatch_, patchBegin_;  ///< triangles, those of patch i from begin[i]
};

}  // namespace

PatchFacing facePatches(std::span<const glm::vec3> positions,
                        std::span<const VertexTriple> triangles,
                        std::span<const std::uint8_t> asInput, const SurfacePatches& patches) {
  if (triangles.empty()) return {};
  return Facing(positions, triangles, asInput, patches).run(asInput);
}

}  // namespace haarlight
