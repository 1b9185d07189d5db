#include "spheres/sphere_cover.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "base/parallel.h"

namespace haarlight {

namespace {

constexpr Ball noBall{glm::dvec3(0), -1};
constexpr double never = std::numeric_limits<double>::infinity();

double squaredDistance(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = a - b;
  return glm::dot(d, d);
}

/// The places sorted by a value each, the largest first; ties in order of place.
std::vector<std::size_t> largestFirst(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  return order;
}

template <typename Result, typename Function>
std::vector<Result> computeForAll(std::size_t count, const Function& function) {
  constexpr std::size_t mostRanges = 256;
  std::vector<Result> results(count);
  parallelFor(count, count / mostRanges + 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) results[i] = function(i);
  });
  return results;
}

}  // namespace

SphereCover::SphereCover(std::span<const glm::vec3> points, std::span<const std::uint32_t> groups,
                         std::size_t groupCount, const SolidGrid& solid)
    : points_({points.begin(), points.end()}), solid_(solid), coverCounts_(points.size()) {
  std::vector<PointList> members(groupCount);
  for (std::size_t i = 0; i < points.size(); ++i) members[groups[i]].push_back(points[i]);
  std::erase_if(members, [](const PointList& list) { return list.empty(); });
  const auto fits = computeForAll<Fit>(members.size(), [&](std::size_t i) {
    return descend(members[i], minimumEnclosingBall(members[i]).center);
  });
  for (const Fit& one : fits) add(one);
}

SphereCover::Fit SphereCover::fitAround(const PointList& points, const glm::dvec3& center) const {
  double largest = 0;
  for (const glm::vec3& point : points) largest = std::max(largest, squaredDistance(point, center));
  const Ball ball{center, std::sqrt(largest)};
  return {ball, solid_.outsideVolume(ball)};
}

/// Pattern search: the cost is continuous but, through the farthest point, not smooth.
SphereCover::Fit SphereCover::descend(const PointList& points, const glm::dvec3& start) const {
  Fit best = fitAround(points, start);
  const double smallestStep = best.ball.radius / 40;
  for (double step = best.ball.radius / 4; step > smallestStep;) {
    const Fit before = best;
    for (int direction = 0; direction < 6; ++direction) {
      glm::dvec3 center = before.ball.center;
      center[direction / 2] += direction % 2 ? -step : step;
      if (const Fit moved = fitAround(points, center); moved.cost < best.cost) best = moved;
    }
    if (!(best.cost < before.cost)) step /= 2;
  }
  return best;
}

SphereCover::Fit SphereCover::fit(const PointList& points, const glm::dvec3& start) const {
  const Fit fromStart = descend(points, start);
  const Fit fromEnclosing = descend(points, minimumEnclosingBall(points).center);
  return fromEnclosing.cost < fromStart.cost ? fromEnclosing : fromStart;
}

SphereCover::PointList SphereCover::pointsOnlyIn(std::size_t ball) const {
  PointList list;
  points_.forEachIn(balls_[ball], [&](std::uint32_t i) {
    if (coverCounts_[i] == 1) list.push_back(points_.points()[i]);
  });
  return list;
}

SphereCover::PointList SphereCover::pointsOnlyIn(std::size_t first, std::size_t second) const {
  PointList list = pointsOnlyIn(second);
  points_.forEachIn(balls_[first], [&](std::uint32_t i) {
    const glm::vec3& point = points_.points()[i];
    if (coverCounts_[i] == 1 || (coverCounts_[i] == 2 && covers(balls_[second], point)))
      list.push_back(point);
  });
  return list;
}

void SphereCover::countCovers(const Ball& ball, int change) {
  points_.forEachIn(ball, [&](std::uint32_t i) {
    coverCounts_[i] = static_cast<std::uint16_t>(coverCounts_[i] + change);
  });
}

void SphereCover::replace(std::size_t ball, const Fit& by) {
  countCovers(balls_[ball], -1);
  balls_[ball] = by.ball;
  costs_[ball] = by.cost;
  countCovers(balls_[ball], +1);
}

void SphereCover::add(const Fit& fit) {
  balls_.push_back(noBall);
  costs_.push_back(0);
  replace(balls_.size() - 1, fit);
}

void SphereCover::removeEmptyBalls() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (balls_[i].radius < 0) continue;
    balls_[kept] = balls_[i];
    costs_[kept++] = costs_[i];
  }
  balls_.resize(kept);
  costs_.resize(kept);
}

void SphereCover::refit() {
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const PointList points = pointsOnlyIn(i);
    const Fit better = points.empty() ? Fit{noBall, 0} : fit(points, balls_[i].center);
    if (points.empty() || better.cost < costs_[i]) replace(i, better);
  }
  removeEmptyBalls();
}

/// Halves the ball's points by 2-means, from two points far from each other.
SphereCover::Split SphereCover::trySplit(std::size_t ball) const {
  const PointList points = pointsOnlyIn(ball);
  Split result{.ball = ball, .parts = {}, .gain = -never};
  if (points.size() < 2) return result;
  const auto farthestFrom = [&](const glm::dvec3& from) {
    return *std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      return squaredDistance(a, from) < squaredDistance(b, from);
    });
  };
  glm::dvec3 centers[2] = {farthestFrom(balls_[ball].center), {}};
  centers[1] = farthestFrom(centers[0]);
  PointList parts[2];
  for (int round = 0; round < 5; ++round) {
    for (PointList& part : parts) part.clear();
    for (const glm::vec3& p : points)
      parts[squaredDistance(p, centers[1]) < squaredDistance(p, centers[0])].push_back(p);
    if (parts[0].empty() || parts[1].empty()) return result;
    for (int i = 0; i < 2; ++i) {
      centers[i] = glm::dvec3(0);
      for (const glm::vec3& p : parts[i]) centers[i] += glm::dvec3(p);
      centers[i] /= double(parts[i].size());
    }
  }
  for (int i = 0; i < 2; ++i) result.parts[i] = fit(parts[i], balls_[ball].center);
  result.gain = costs_[ball] - result.parts[0].cost - result.parts[1].cost;
  return result;
}

/// The cheapest union with one of the three neighbours that overlap it most.
SphereCover::Merge SphereCover::tryMerge(std::size_t ball) const {
  std::vector<double> overlaps(balls_.size(), -never);
  for (std::size_t i = 0; i < balls_.size(); ++i)
    if (i != ball && balls_[i].radius >= 0)
      overlaps[i] = balls_[i].radius - glm::distance(balls_[i].center, balls_[ball].center);
  const auto order = largestFirst(overlaps);
  Merge best{.first = ball, .second = ball, .whole = {}, .loss = never};
  for (std::size_t k = 0; k < std::min<std::size_t>(3, order.size()); ++k) {
    const std::size_t other = order[k];
    if (overlaps[other] == -never) break;
    const PointList points = pointsOnlyIn(ball, other);
    if (points.empty()) continue;
    const Fit whole = fit(points, (balls_[ball].center + balls_[other].center) / 2.0);
    const double loss = whole.cost - costs_[ball] - costs_[other];
    if (loss < best.loss) best = {ball, other, whole, loss};
  }
  return best;
}

void SphereCover::apply(const Split& split) {
  add(split.parts[1]);
  replace(split.ball, split.parts[0]);
}

void SphereCover::splitUpTo(std::size_t count) {
  while (balls_.size() < count) {
    const auto splits =
        computeForAll<Split>(balls_.size(), [&](std::size_t i) { return trySplit(i); });
    std::vector<double> gains;
    for (const Split& split : splits) gains.push_back(split.gain);
    const std::size_t before = balls_.size();
    for (const std::size_t i : largestFirst(gains)) {
      if (!(gains[i] > 0) || balls_.size() == count) break;
      apply(splits[i]);
    }
    if (balls_.size() == before) return;
  }
}

void SphereCover::exchange() {
  const std::size_t count = balls_.size();
  const auto merges = computeForAll<Merge>(count, [&](std::size_t i) { return tryMerge(i); });
  const auto splits = computeForAll<Split>(count, [&](std::size_t i) { return trySplit(i); });
  std::vector<double> savings, gains;
  for (const Merge& merge : merges) savings.push_back(-merge.loss);
  for (const Split& split : splits) gains.push_back(split.gain);
  const auto mergeOrder = largestFirst(savings), splitOrder = largestFirst(gains);

  std::vector<bool> changed(count);
  auto nextSplit = splitOrder.begin();
  for (const std::size_t i : mergeOrder) {
    nextSplit =
        std::find_if(nextSplit, splitOrder.end(), [&](std::size_t s) { return !changed[s]; });
    const double gain = nextSplit == splitOrder.end() ? 0 : std::max(gains[*nextSplit], 0.0);
    if (merges[i].loss >= gain) break;
    if (changed[i] || changed[merges[i].second]) continue;
    const Merge merge = tryMerge(i);  // its neighbours may have changed since
    if (changed[merge.second]) continue;
    if (merge.loss < 0) {
      replace(merge.first, merge.whole);
      replace(merge.second, {noBall, 0});
    } else {
      if (nextSplit == splitOrder.end()) break;
      const std::size_t divided = *nextSplit;
      if (divided == merge.first || divided == merge.second) continue;
      const Split split = trySplit(divided);
      if (split.gain <= merge.loss) continue;
      changed[divided] = true;
      replace(merge.first, merge.whole);
      replace(merge.second, split.parts[1]);
      replace(divided, split.parts[0]);
    }
    changed[merge.first] = changed[merge.second] = true;
  }
  removeEmptyBalls();
}

std::size_t SphereCover::cheapestToGrow(const glm::vec3& point) const {
  std::size_t best = 0;
  double smallestGrowth = never;
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    const double radius = balls_[b].radius;
    const double needed = glm::distance(glm::dvec3(point), balls_[b].center);
    const double growth = needed * needed * needed - radius * radius * radius;
    if (growth >= smallestGrowth) continue;
    smallestGrowth = growth;
    best = b;
  }
  return best;
}

void SphereCover::addPoints(std::span<const glm::vec3> points) {
  std::vector<glm::vec3> all = points_.points();
  all.insert(all.end(), points.begin(), points.end());
  points_ = PointBlocks(std::move(all));
  coverCounts_.assign(points_.points().size(), 0);
  for (const Ball& ball : balls_) countCovers(ball, +1);

  const auto growing = computeForAll<std::size_t>(coverCounts_.size(), [&](std::size_t i) {
    return coverCounts_[i] > 0 ? balls_.size() : cheapestToGrow(points_.points()[i]);
  });
  for (std::size_t i = 0; i < growing.size(); ++i) {
    if (growing[i] == balls_.size()) continue;
    Ball& ball = balls_[growing[i]];
    ball.radius =
        std::max(ball.radius, std::sqrt(squaredDistance(points_.points()[i], ball.center)));
  }
  coverCounts_.assign(coverCounts_.size(), 0);
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    costs_[b] = solid_.outsideVolume(balls_[b]);
    countCovers(balls_[b], +1);
  }
}

double SphereCover::cost() const {
  return std::accumulate(costs_.begin(), costs_.end(), 0.0);
}

}  // namespace haarlight
