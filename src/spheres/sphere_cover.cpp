#include "spheres/sphere_cover.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "spheres/ranking.h"

namespace haarlight {

namespace {

constexpr Ball noBall{glm::dvec3(0), -1};
constexpr double leastGain = 1e-6;  // of a split, in cubed radii
constexpr double never = std::numeric_limits<double>::infinity();

double squaredDistance(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = a - b;
  return glm::dot(d, d);
}

}  // namespace

SphereCover::SphereCover(std::shared_ptr<const PointBlocks> points,
                         std::span<const std::uint32_t> groups, std::size_t groupCount,
                         const SolidGrid& solid)
    : points_(std::move(points)), solid_(&solid), coverCounts_(points_->points().size()) {
  std::vector<PointList> members(groupCount);
  for (std::size_t i = 0; i < groups.size(); ++i)
    members[groups[i]].push_back(points_->points()[i]);
  std::erase_if(members, [](const PointList& list) { return list.empty(); });
  const auto fits = computeForAll<BallFit>(members.size(), [&](std::size_t i) {
    return fit(members[i], minimumEnclosingBall(members[i]).center);
  });
  for (const BallFit& one : fits) add(one);
}

SphereCover::PointList SphereCover::pointsOnlyIn(std::size_t ball, std::uint64_t* checksum) const {
  PointList list;
  points_->forEachIn(balls_[ball], [&](std::uint32_t i) {
    if (coverCounts_[i] != 1) return;
    list.push_back(points_->points()[i]);
    if (checksum) *checksum = (*checksum ^ i) * 0x9e3779b97f4a7c15;
  });
  return list;
}

double SphereCover::exclusiveShare(std::size_t ball) const {
  std::size_t all = 0, exclusive = 0;
  points_->forEachIn(balls_[ball], [&](std::uint32_t i) {
    ++all;
    exclusive += coverCounts_[i] == 1;
  });
  return all == 0 ? 0 : double(exclusive) / double(all);
}

void SphereCover::countCovers(const Ball& ball, int change) {
  points_->forEachIn(ball, [&](std::uint32_t i) {
    coverCounts_[i] = static_cast<std::uint16_t>(coverCounts_[i] + change);
  });
}

void SphereCover::replace(std::size_t ball, const BallFit& by) {
  countCovers(balls_[ball], -1);
  balls_[ball] = by.ball;
  costs_[ball] = by.cost;
  countCovers(balls_[ball], +1);
}

void SphereCover::add(const BallFit& fit) {
  balls_.push_back(noBall);
  costs_.push_back(0);
  fittedTo_.push_back(0);
  replace(balls_.size() - 1, fit);
}

void SphereCover::removeEmptyBalls() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (balls_[i].radius < 0) continue;
    balls_[kept] = balls_[i];
    fittedTo_[kept] = fittedTo_[i];
    costs_[kept++] = costs_[i];
  }
  fittedTo_.resize(kept);
  balls_.resize(kept);
  costs_.resize(kept);
}

/// Whether the ball moved.
bool SphereCover::refit(std::size_t ball) {
  if (balls_[ball].radius < 0) return false;
  std::uint64_t checksum = 1;  // of no points; a new ball has 0
  const PointList points = pointsOnlyIn(ball, &checksum);
  if (checksum == fittedTo_[ball]) return false;
  fittedTo_[ball] = checksum;
  const BallFit better = points.empty() ? BallFit{noBall, 0} : fit(points, balls_[ball].center);
  if (!points.empty() && !(better.cost < costs_[ball])) return false;
  replace(ball, better);
  return true;
}

void SphereCover::refit() {
  for (std::size_t i = 0; i < balls_.size(); ++i) refit(i);
  removeEmptyBalls();
}

/// Balls that overlap one of the changed ones, those included.
std::vector<std::size_t> SphereCover::around(const std::vector<bool>& changed) const {
  std::vector<Ball> centers;
  for (std::size_t i = 0; i < balls_.size(); ++i)
    if (changed[i] && balls_[i].radius >= 0) centers.push_back(balls_[i]);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < balls_.size(); ++i)
    if (balls_[i].radius >= 0 && std::ranges::any_of(centers, [&](const Ball& ball) {
          const double reach = balls_[i].radius + ball.radius;
          return squaredDistance(balls_[i].center, ball.center) < reach * reach;
        }))
      found.push_back(i);
  return found;
}

/// Refits the changed balls and those that overlap them, until little moves.
void SphereCover::settle(std::vector<bool>& changed) {
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    std::vector<bool> moved(balls_.size());
    for (const std::size_t i : around(changed)) moved[i] = refit(i);
    changed = moved;
  }
}

/// The points of the ball go to the balls that grow least.
void SphereCover::remove(std::size_t ball, std::vector<bool>& changed) {
  const PointList orphans = pointsOnlyIn(ball);
  std::vector<bool> self(balls_.size());
  self[ball] = true;
  std::vector<std::size_t> neighbours = around(self);
  std::erase(neighbours, ball);
  if (neighbours.empty()) {
    neighbours.resize(balls_.size());
    std::iota(neighbours.begin(), neighbours.end(), std::size_t(0));
  }
  replace(ball, {noBall, 0});
  std::vector<std::pair<std::size_t, glm::vec3>> adopted;
  for (const glm::vec3& point : orphans)
    adopted.emplace_back(cheapestToGrow(neighbours, point), point);
  std::stable_sort(adopted.begin(), adopted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto begin = adopted.begin(); begin != adopted.end();) {
    const std::size_t parent = begin->first;
    PointList points = pointsOnlyIn(parent);
    for (; begin != adopted.end() && begin->first == parent; ++begin)
      points.push_back(begin->second);
    replace(parent, fit(points, balls_[parent].center));
    changed[parent] = true;
  }
}

void SphereCover::teleport(std::size_t from, std::size_t divided) {
  std::vector<bool> changed(balls_.size());
  remove(from, changed);
  const Split split = trySplit(divided);
  if (split.gain == -never) return;
  replace(divided, split.parts[0]);
  replace(from, split.parts[1]);
  changed[divided] = changed[from] = true;
  settle(changed);
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
  for (int i = 0; i < 2; ++i) result.parts[i] = fit(parts[i], centers[i]);
  result.gain = costs_[ball] - result.parts[0].cost - result.parts[1].cost;
  return result;
}

void SphereCover::splitUpTo(std::size_t count) {
  while (balls_.size() < count) {
    const auto splits =
        computeForAll<Split>(balls_.size(), [&](std::size_t i) { return trySplit(i); });
    std::vector<double> gains;
    for (const Split& split : splits) gains.push_back(split.gain);
    const std::size_t before = balls_.size();
    for (const std::size_t i : largestFirst(gains)) {
      // Rounding makes a ball within the solid cost a little.
      if (balls_.size() == count) break;
      if (!(gains[i] > leastGain * std::pow(balls_[i].radius, 3))) continue;
      add(splits[i].parts[1]);
      replace(i, splits[i].parts[0]);
    }
    if (balls_.size() == before) return;
  }
}

std::size_t SphereCover::cheapestToGrow(std::span<const std::size_t> among,
                                        const glm::vec3& point) const {
  std::size_t best = 0;
  double smallestGrowth = never;
  for (const std::size_t b : among) {
    const double radius = balls_[b].radius;
    if (radius < 0) continue;
    const double needed = glm::distance(glm::dvec3(point), balls_[b].center);
    const double growth = needed * needed * needed - radius * radius * radius;
    if (growth >= smallestGrowth) continue;
    smallestGrowth = growth;
    best = b;
  }
  return best;
}

void SphereCover::addPoints(std::span<const glm::vec3> points) {
  std::vector<glm::vec3> all = points_->points();
  all.insert(all.end(), points.begin(), points.end());
  points_ = std::make_shared<const PointBlocks>(std::move(all));
  coverCounts_.assign(points_->points().size(), 0);
  for (const Ball& ball : balls_) countCovers(ball, +1);

  std::vector<std::size_t> everyBall(balls_.size());
  std::iota(everyBall.begin(), everyBall.end(), std::size_t(0));
  const auto growing = computeForAll<std::size_t>(coverCounts_.size(), [&](std::size_t i) {
    return coverCounts_[i] > 0 ? balls_.size() : cheapestToGrow(everyBall, points_->points()[i]);
  });
  for (std::size_t i = 0; i < growing.size(); ++i) {
    if (growing[i] == balls_.size()) continue;
    Ball& ball = balls_[growing[i]];
    ball.radius =
        std::max(ball.radius, std::sqrt(squaredDistance(points_->points()[i], ball.center)));
  }
  coverCounts_.assign(coverCounts_.size(), 0);
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    costs_[b] = outsideCost(balls_[b], *solid_);
    countCovers(balls_[b], +1);
  }
}

double SphereCover::cost() const {
  return std::accumulate(costs_.begin(), costs_.end(), 0.0);
}

}  // namespace haarlight
