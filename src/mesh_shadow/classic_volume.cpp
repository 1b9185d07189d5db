#include "mesh_shadow/classic_volume.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "base/parallel.h"

namespace haarlight {

/// Faces in the picture, by homogeneous coordinates (Olano and Greer 1997), so that nothing is cut
/// at the eye's plane: a pixel's direction is a sum of the corners' with weights b, all of which
/// are positive where it passes through the face, and 1/t is Σ b w.
class ClassicVolume::Raster {
 public:
  static std::optional<Raster> of(const Face& face, const PixelView& view,
                                  const glm::dmat3& toPixels) {
    std::array<glm::dvec3, 3> corners;
    for (int i = 0; i < 3; ++i)
      corners[i] = toPixels * (face.corners[i].place - face.corners[i].w * view.eye);
    const double volume = glm::dot(corners[0], glm::cross(corners[1], corners[2]));
    if (volume == 0) return std::nullopt;  // seen edge-on
    Raster raster;
    raster.findExtent(corners, view);
    if (raster.first.x > raster.last.x || raster.first.y > raster.last.y) return std::nullopt;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 edge = glm::cross(corners[(i + 1) % 3], corners[(i + 2) % 3]);
      raster.edges[i] = volume < 0 ? -edge : edge;
      raster.inverseDepth += face.corners[i].w / volume * edge;
    }
    const bool pixelsAreTurned = glm::determinant(toPixels) < 0;
    const bool entersSeenFromEye = (volume < 0) != pixelsAreTurned;
    raster.weight = entersSeenFromEye ? face.weight : -face.weight;
    return raster;
  }

  void addRow(int y, const PixelView& view, std::span<const double> depths,
              std::span<std::int32_t> counts, double nearer) const {
    if (y < first.y || y > last.y) return;
    const auto [from, to] = span(y);
    for (int x = from; x <= to; ++x) {
      const glm::dvec3 pixel(x, y, 1);
      if (!covers(pixel)) continue;
      const std::size_t i = std::size_t(y) * std::size_t(view.width) + std::size_t(x);
      if (glm::dot(inverseDepth, pixel) * depths[i] * nearer > 1) counts[i] += weight;
    }
  }

 private:
  /// A pixel on an edge belongs to the face on one side of it.
  bool covers(const glm::dvec3& pixel) const {
    return std::ranges::all_of(edges, [&](const glm::dvec3& edge) {
      const double side = glm::dot(edge, pixel);
      return side > 0 || (side == 0 && (edge.x > 0 || (edge.x == 0 && edge.y > 0)));
    });
  }

  /// The pixels of a row that it may cover, and perhaps one more on either side.
  std::pair<int, int> span(int y) const {
    double from = first.x, to = last.x;
    for (const glm::dvec3& edge : edges) {
      const double place = -(edge.y * y + edge.z) / edge.x;
      if (edge.x > 0) from = std::max(from, std::floor(place));
      if (edge.x < 0) to = std::min(to, std::ceil(place));
    }
    return {int(from), int(to)};
  }

  /// The pixels around it: around its corners if all are in front of the eye, else around where it
  /// passes the plane a little before the eye too.
  void findExtent(const std::array<glm::dvec3, 3>& corners, const PixelView& view) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    const auto include = [&](const glm::dvec3& corner) {
      low = glm::min(low, corner / corner.z), high = glm::max(high, corner / corner.z);
    };
    double largest = 0;
    for (const glm::dvec3& corner : corners)
      largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    const double plane = 1e-9 * largest;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % 3];
      if (a.z >= plane) include(a);
      if ((a.z < plane) != (b.z < plane)) {
        glm::dvec3 cut = a + (plane - a.z) / (b.z - a.z) * (b - a);
        cut.z = plane;
        include(cut);
      }
    }
    const glm::dvec3 end(view.width - 1, view.height - 1, 0);
    first = glm::ivec3(glm::clamp(glm::ceil(low), glm::dvec3(0), end + 1.0));
    last = glm::ivec3(glm::clamp(glm::floor(high), glm::dvec3(-1), end));
  }

  std::array<glm::dvec3, 3> edges;
  glm::dvec3 inverseDepth{0};
  glm::ivec3 first{0}, last{0};
  int weight = 0;
};

ClassicVolume::ClassicVolume(const LitMesh& mesh) : mesh_(mesh) {
  addCaps();
  addSides();
}

void ClassicVolume::addCaps() {
  for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t) {
    if (mesh_.facing(t) == 0) continue;
    auto corners = mesh_.corners(t);
    if (mesh_.facing(t) < 0) std::swap(corners[1], corners[2]);
    faces_.push_back({{Corner{corners[0], 1}, {corners[1], 1}, {corners[2], 1}}, 1});
  }
}

ClassicVolume::Corner ClassicVolume::beyond(std::uint32_t vertex) const {
  return {-mesh_.towardsLight(mesh_.positions()[vertex]), 0};
}

void ClassicVolume::addSides() {
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh_.triangles());
  forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
    int weight = 0;
    for (const EdgeUse& use : edge)
      weight += (runsUpward(mesh_.triangles(), use) ? 1 : -1) * mesh_.facing(use.triangle());
    if (weight == 0) return;
    const Corner low{mesh_.positions()[edge[0].low], 1}, high{mesh_.positions()[edge[0].high], 1};
    const Corner beyondLow = beyond(edge[0].low), beyondHigh = beyond(edge[0].high);
    faces_.push_back({{high, low, beyondLow}, weight});
    if (beyondLow.place != beyondHigh.place)
      faces_.push_back({{high, beyondLow, beyondHigh}, weight});
  });
}

namespace {

/// On which side of the plane through the origin, a and b a direction points: 1 or −1, and one of
/// them also within the plane, as if the direction were (x + ε, y + ε², z + ε³). So of the
/// triangles at an edge, or at a corner, exactly one on each side of the mesh is passed.
int sideOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& direction) {
  const glm::dvec3 normal = glm::cross(a, b);
  for (const double value : {glm::dot(normal, direction), normal.x, normal.y, normal.z})
    if (value != 0) return value < 0 ? -1 : 1;
  return 0;
}

}  // namespace

/// The number of triangles between the eye and the light.
int ClassicVolume::countAtEye(const glm::dvec3& eye) const {
  int count = 0;
  const Ray ray = segmentToLight(eye, mesh_.light());
  for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t) {
    const TriangleCorners corners = mesh_.corners(t);
    const glm::dvec3 a = corners[0] - eye, b = corners[1] - eye, c = corners[2] - eye;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const int side = sideOf(a, b, ray.direction);
    const bool passes = side == sideOf(b, c, ray.direction) && side == sideOf(c, a, ray.direction);
    const double at = glm::dot(normal, a) / glm::dot(normal, ray.direction);
    count += passes && at >= ray.near && at <= ray.far;
  }
  return count;
}

void ClassicVolume::addCounts(const PixelView& view, std::span<const double> depths,
                              std::span<std::int32_t> counts, double relativeBias) const {
  const int atEye = countAtEye(view.eye);
  for (std::int32_t& count : counts) count += atEye;
  const glm::dmat3 toPixels = glm::inverse(glm::dmat3(view.column, view.row, view.corner));
  std::vector<Raster> rasters;
  for (const Face& face : faces_)
    if (const auto raster = Raster::of(face, view, toPixels)) rasters.push_back(*raster);
  parallelFor(std::size_t(view.height), 8, [&](std::size_t begin, std::size_t end) {
    for (const Raster& raster : rasters)
      for (std::size_t y = begin; y < end; ++y)
        raster.addRow(int(y), view, depths, counts, 1 - relativeBias);
  });
}

}  // namespace haarlight
