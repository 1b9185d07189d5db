#include "mesh_shadow/hidden_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "shadow/shaft.h"

namespace haarlight {

namespace {

/// Triangles that hang together by edges of two.
using Sheet = std::vector<std::uint32_t>;

/// Sheets without crossed triangles, and without those that the light sees edge-on; the largest
/// first.
std::vector<Sheet> findSheets(const LitMesh& mesh, std::span<const std::uint8_t> crossed) {
  std::vector<Sheet> sheets;
  std::vector<std::uint8_t> isFound(crossed.begin(), crossed.end());
  for (std::uint32_t first = 0; first < mesh.triangleCount(); ++first) {
    if (isFound[first]) continue;
    isFound[first] = 1;
    Sheet sheet{first};
    for (std::size_t i = 0; i < sheet.size(); ++i)
      for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t next = mesh.neighbor(sheet[i], corner);
        if (!mesh.isTriangle(next) || isFound[next]) continue;
        isFound[next] = 1;
        sheet.push_back(next);
      }
    sheets.push_back(std::move(sheet));
  }
  std::ranges::stable_sort(sheets, std::ranges::greater{}, [](const Sheet& s) { return s.size(); });
  return sheets;
}

/// By how much the winding number falls from the light's side of a triangle's middle to the light.
/// Nothing if the ray passes a triangle's edge, as far as rounding can tell.
class WindingRay {
 public:
  WindingRay(const LitMesh& mesh, std::uint32_t triangle) : mesh_(mesh), from_(triangle) {
    const TriangleCorners t = mesh.corners(triangle);
    start_ = (t[0] + t[1] + t[2]) / 3.0;
    way_ = mesh.towardsLight(start_);
    end_ = std::holds_alternative<PointLight>(mesh.light())
               ? 1
               : std::numeric_limits<double>::infinity();
    const double size =
        largestCoordinate(united(mesh.bounds(), {start_, start_})) + glm::length(start_);
    least_ = 1e-12 * size * size * glm::length(way_);
  }

  std::optional<int> count() const {
    int sum = 0;
    for (std::uint32_t triangle = 0; triangle < mesh_.triangleCount(); ++triangle) {
      if (triangle == from_) continue;
      const auto passed = passes(triangle);
      if (!passed) return std::nullopt;
      if (*passed) sum += mesh_.facing(triangle);
    }
    return sum;
  }

 private:
  std::optional<bool> passes(std::uint32_t triangle) const {
    const TriangleCorners t = mesh_.corners(triangle);
    const glm::dvec3 a = t[0] - start_, b = t[1] - start_, c = t[2] - start_;
    const glm::dvec3 wayA = glm::cross(way_, a), wayC = glm::cross(way_, c);
    const double ab = glm::dot(wayA, b), bc = -glm::dot(wayC, b), ca = glm::dot(wayC, a);
    const auto [low, high] = std::minmax({ab, bc, ca});
    if (low < -least_ && high > least_) return false;
    if (low <= least_ && high >= -least_) return std::nullopt;
    // The line passes within the triangle; where, the triangle's plane tells.
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double at = glm::dot(normal, a) / glm::dot(normal, way_);
    constexpr double rounding = 1e-9;
    if (std::abs(at) < rounding || std::abs(at - end_) < rounding) return std::nullopt;
    return at > 0 && at < end_;
  }

  const LitMesh& mesh_;
  std::uint32_t from_;
  glm::dvec3 start_{0}, way_{0};
  double end_, least_;
};

/// How much larger the winding number is on a sheet's outer side than at the light.
std::optional<int> windingOutside(const LitMesh& mesh, const Sheet& sheet) {
  constexpr std::size_t mostTries = 8;
  std::size_t tries = 0;
  for (const std::uint32_t triangle : sheet) {
    if (mesh.facing(triangle) == 0) continue;
    if (const auto count = WindingRay(mesh, triangle).count())
      return mesh.facing(triangle) > 0 ? *count : *count - 1;
    if (++tries == mostTries) break;
  }
  return std::nullopt;
}

/// Whether a triangle with a certain edge lies between the light and another one with the edge.
bool isInFront(const LitMesh& mesh, std::uint32_t triangle, std::uint32_t other) {
  const TriangleCorners t = mesh.corners(triangle);
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  double furthest = 0, least = 0;
  for (const glm::dvec3& corner : mesh.corners(other)) {
    const glm::dvec3 way = corner - t[0];
    furthest = std::min(furthest, mesh.facing(triangle) * glm::dot(normal, way));
    least = std::max(least, 1e-12 * glm::length(normal) * glm::length(way));
  }
  return furthest < -least;
}

}  // namespace

std::vector<std::uint8_t> findHiddenTriangles(const LitMesh& mesh,
                                              std::span<const std::uint8_t> crossed) {
  std::vector<std::uint8_t> hidden(mesh.triangleCount());
  if (!mesh.isClosed() || mesh.holdsLight()) return hidden;
  std::vector<Sheet> sheets = findSheets(mesh, crossed);
  constexpr std::size_t mostSheets = 32;
  sheets.resize(std::min(sheets.size(), mostSheets));
  for (const Sheet& sheet : sheets) {
    const auto outside = windingOutside(mesh, sheet);
    if (!outside) continue;
    for (const std::uint32_t triangle : sheet) {
      const int facing = mesh.facing(triangle);
      const int towardsLight = facing > 0 ? *outside : *outside + 1;
      hidden[triangle] = facing != 0 && towardsLight != 0;
    }
  }
  return hidden;
}

bool isHiddenFold(const LitMesh& mesh, std::size_t edge, std::span<const std::uint8_t> plain,
                  std::span<const std::uint8_t> hidden) {
  const std::uint32_t corner = mesh.silhouetteCorners()[edge], one = corner / 3;
  const std::uint32_t other = mesh.neighbor(one, int(corner % 3));
  if (!mesh.isTriangle(other) || !plain[one] || !plain[other]) return false;
  if (mesh.facing(one) == 0 || mesh.facing(other) == 0) return false;
  return (hidden[one] && isInFront(mesh, one, other)) ||
         (hidden[other] && isInFront(mesh, other, one));
}

}  // namespace haarlight
