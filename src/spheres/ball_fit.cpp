#include "spheres/ball_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "spheres/powell.h"

namespace haarlight {

namespace {

/// Points in lanes, to find the farthest from a place quickly.
class FarthestPoint {
 public:
  explicit FarthestPoint(std::span<const glm::vec3> points) {
    groups_.resize((points.size() + lanes - 1) / lanes);
    for (std::size_t i = 0; i < groups_.size() * lanes; ++i) {
      const glm::vec3& point = points[std::min(i, points.size() - 1)];
      for (int axis = 0; axis < 3; ++axis) groups_[i / lanes][axis][i % lanes] = point[axis];
    }
  }

  double distanceFrom(const glm::dvec3& place) const {
    constexpr double roundingOfFloat = 1e-6;
    const glm::vec3 from(place);
    std::array<float, lanes> largest{};
    for (const Group& group : groups_)
      for (std::size_t i = 0; i < lanes; ++i) {
        const float x = group[0][i] - from.x, y = group[1][i] - from.y, z = group[2][i] - from.z;
        const float square = x * x + y * y + z * z;
        largest[i] = square > largest[i] ? square : largest[i];
      }
    const double square = *std::ranges::max_element(largest);
    // The rounding of the place to float moves it by no more than a unit in its last place.
    return std::sqrt(square) * (1 + roundingOfFloat) + 2e-7 * glm::length(place);
  }

 private:
  static constexpr std::size_t lanes = 8;
  using Group = std::array<std::array<float, lanes>, 3>;
  std::vector<Group> groups_;
};

/// Pattern search: the farthest point makes kinks in the cost, at which quadratic models stall.
template <typename Cost>
void polish(std::array<double, 3>& place, const Cost& cost, double least, double step,
            double smallestStep) {
  while (step > smallestStep) {
    bool moved = false;
    for (std::size_t direction = 0; direction < 6; ++direction) {
      std::array<double, 3> next = place;
      next[direction / 2] += direction % 2 ? -step : step;
      const double there = cost(next);
      if (!(there < least)) continue;
      least = there;
      place = next;
      moved = true;
    }
    if (!moved) step /= 2;
  }
}

}  // namespace

double outsideCost(const Ball& ball, const SolidGrid& solid) {
  constexpr double cellsToEachSide = 12;
  return solid.outsideVolume(ball, solid.levelFor(ball.radius, cellsToEachSide));
}

// The level of the grid stays the same during a search, so that the cost is continuous.
BallFit fitAround(std::span<const glm::vec3> points, const glm::dvec3& start,
                  const SolidGrid& solid, bool polished) {
  constexpr double cellsToEachSide = 5;
  const FarthestPoint farthest(points);
  const double radius = farthest.distanceFrom(start);
  const int level = solid.levelFor(radius, cellsToEachSide);
  const auto ballAt = [&](std::span<const double> place) {
    const glm::dvec3 center(place[0], place[1], place[2]);
    return Ball{center, farthest.distanceFrom(center)};
  };
  std::array<double, 3> place{start.x, start.y, start.z};
  const auto volumeAt = [&](std::span<const double> at) {
    return solid.outsideVolume(ballAt(at), level);
  };
  const double volume = minimizeByPowell(
      place, volumeAt,
      {.firstStep = radius / 6, .smallestStep = radius / 100, .mostEvaluations = 50});
  if (polished) polish(place, volumeAt, volume, radius / 20, radius / 400);
  const Ball ball = ballAt(place);
  return {ball, outsideCost(ball, solid)};
}

}  // namespace haarlight
