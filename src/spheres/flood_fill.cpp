#include "spheres/flood_fill.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "spheres/ranking.h"

namespace haarlight {

namespace {

constexpr std::size_t mostNear = 16;

/// Volume outside the solid of a ball that grows around a centre, tabulated.
class Growth {
 public:
  Growth(const glm::dvec3& center, const SolidGrid& solid) {
    constexpr double cellsToEachSide = 8;
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      const double radius = double(i) * step;
      volumes_[i] = solid.outsideVolume({center, radius}, solid.levelFor(radius, cellsToEachSide));
      // Levels differ by a little where a ball grows from one to the next.
      if (i > 0) volumes_[i] = std::max(volumes_[i], volumes_[i - 1]);
    }
  }

  double outside(double radius) const {
    const double place = std::min(radius / step, double(volumes_.size() - 1) - 1e-9);
    const auto i = static_cast<std::size_t>(place);
    return volumes_[i] + (place - double(i)) * (volumes_[i + 1] - volumes_[i]);
  }

 private:
  static constexpr double step = 1.0 / 64;  ///< unit frame: nothing is farther apart than √3
  std::array<double, 112> volumes_{};
};

/// The centres nearest to a point, the nearest first; the list ends with `none` when there are
/// fewer.
struct Nearest {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::array<std::uint32_t, mostNear> centers;
  std::array<double, mostNear> distances;
};

Nearest nearestTo(const glm::dvec3& point, std::span<const glm::dvec3> centers) {
  Nearest nearest;
  nearest.centers.fill(Nearest::none);
  nearest.distances.fill(std::numeric_limits<double>::infinity());
  for (std::uint32_t c = 0; c < centers.size(); ++c) {
    const double distance = glm::distance(point, centers[c]);
    if (distance >= nearest.distances.back()) continue;
    std::size_t i = mostNear - 1;
    for (; i > 0 && nearest.distances[i - 1] > distance; --i) {
      nearest.distances[i] = nearest.distances[i - 1];
      nearest.centers[i] = nearest.centers[i - 1];
    }
    nearest.distances[i] = distance;
    nearest.centers[i] = c;
  }
  return nearest;
}

}  // namespace

std::vector<std::uint32_t> floodFill(std::span<const glm::vec3> points,
                                     std::span<const glm::dvec3> centers, const SolidGrid& solid) {
  const auto growths = computeForAll<std::optional<Growth>>(
      centers.size(), [&](std::size_t c) { return Growth(centers[c], solid); });
  const auto nearest = computeForAll<Nearest>(
      points.size(), [&](std::size_t i) { return nearestTo(glm::dvec3(points[i]), centers); });
  std::vector<double> distances;
  for (const Nearest& one : nearest) distances.push_back(one.distances.front());

  std::vector<double> radii(centers.size());
  std::vector<std::uint32_t> joined(points.size());
  for (const std::size_t i : smallestFirst(distances)) {
    double leastRise = std::numeric_limits<double>::infinity(), depth = 0;
    for (std::size_t k = 0; k < mostNear && nearest[i].centers[k] != Nearest::none; ++k) {
      const std::uint32_t c = nearest[i].centers[k];
      const double distance = nearest[i].distances[k], radius = std::max(radii[c], distance);
      const double rise = growths[c]->outside(radius) - growths[c]->outside(radii[c]);
      if (rise > leastRise || (rise == leastRise && radii[c] - distance <= depth)) continue;
      leastRise = rise;
      depth = radii[c] - distance;
      joined[i] = c;
    }
    radii[joined[i]] =
        std::max(radii[joined[i]], glm::distance(glm::dvec3(points[i]), centers[joined[i]]));
  }
  return joined;
}

}  // namespace haarlight
