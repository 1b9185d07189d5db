#include "spheres/cover_fit.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "mesh/random.h"
#include "spheres/flood_fill.h"
#include "spheres/point_clusters.h"
#include "spheres/ranking.h"
#include "spheres/sphere_cover.h"
#include "spheres/teleport.h"

namespace haarlight {

namespace {

/// The ball taken away and the one divided.
struct Move {
  std::size_t from, divided;
};

class CoverSearch {
 public:
  CoverSearch(const FitProblem& problem, std::size_t count, std::uint64_t seed, FitMonitor& monitor)
      : problem_(&problem),
        count_(count),
        volume_(problem.solid.volume()),
        random_(seed),
        monitor_(&monitor),
        cover_(startingCover(seed)) {
    // Where nothing is inside, in parts of a cube around the mesh.
    if (!(volume_ > 0)) volume_ = 1;
  }

  /// Floods and refits in turn, as long as that lowers the sum.
  void cluster() {
    constexpr int mostRounds = 12;
    constexpr double leastGain = 0.005;
    for (int round = 0; round < mostRounds && !monitor_->mustStop(); ++round) {
      std::vector<glm::dvec3> centers;
      for (const Ball& ball : cover_.balls()) centers.push_back(ball.center);
      const auto& points = cover_.points()->points();
      SphereCover next(cover_.points(), floodFill(points, centers, problem_->solid), centers.size(),
                       problem_->solid);
      if (cover_.polishesFits()) next.polishFits();
      next.refit();
      if (!(next.cost() < cover_.cost() * (1 - leastGain))) break;
      cover_ = std::move(next);
      monitor_->report(double(round + 1) / mostRounds, cover_.balls().size(), error(cover_));
    }
    cover_.splitUpTo(count_);
    report(1);
  }

  void teleport(const TeleportPlan& plan) {
    if (cover_.balls().size() < 2) return;
    order();
    improveByTeleports(
        cover_, plan, *monitor_, [&](const SphereCover&) { return choose(); },
        [](SphereCover& cover, const Move& move) { cover.teleport(move.from, move.divided); },
        [&](const SphereCover& cover) { return error(cover); }, [&] { order(); });
  }

  /// Points that no ball holds are not looked for before most is settled: there are many.
  void takeUpDemanded() {
    const auto missed = computeForAll<std::uint8_t>(problem_->demanded.size(), [&](std::size_t i) {
      return std::ranges::none_of(
          cover_.balls(), [&](const Ball& ball) { return covers(ball, problem_->demanded[i]); });
    });
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < missed.size(); ++i)
      if (missed[i]) points.push_back(problem_->demanded[i]);
    if (!points.empty()) cover_.addPoints(points);
    cover_.refit();
    cover_.splitUpTo(count_);
  }

  void polishFits() { cover_.polishFits(); }

  void report(double part) { monitor_->report(part, cover_.balls().size(), error(cover_)); }
  double cost() const { return cover_.cost(); }
  double error() const { return error(cover_); }

  std::vector<Ball> balls() const {
    std::vector<Ball> balls = cover_.balls();
    std::erase_if(balls, [](const Ball& ball) { return ball.radius < 0; });
    return balls;
  }

 private:
  double error(const SphereCover& cover) const { return cover.cost() / volume_; }

  SphereCover startingCover(std::uint64_t seed) const {
    std::vector<glm::vec3> all = problem_->surface;
    all.insert(all.end(), problem_->interior.begin(), problem_->interior.end());
    const auto points = std::make_shared<const PointBlocks>(std::move(all));
    SphereCover cover(points, clusterPoints(points->points(), count_, seed), count_,
                      problem_->solid);
    cover.refit();
    return cover;
  }

  void order() {
    const std::size_t count = cover_.balls().size();
    needless_ = smallestFirst(
        computeForAll<double>(count, [&](std::size_t i) { return cover_.exclusiveShare(i); }));
    bulging_ =
        largestFirst(computeForAll<double>(count, [&](std::size_t i) { return cover_.cost(i); }));
  }

  Move choose() {
    Move move{0, 0};
    while (move.from == move.divided)
      move = {pickEarly(needless_, 2, random_), pickEarly(bulging_, 2, random_)};
    return move;
  }

  const FitProblem* problem_;
  std::size_t count_;
  double volume_;
  Random random_;
  FitMonitor* monitor_;
  SphereCover cover_;
  std::vector<std::size_t> needless_, bulging_;
};

constexpr std::size_t fewBalls = 32;

/// Few balls take little time, and where they end depends on where they start.
std::size_t startsFor(std::size_t count) {
  return std::clamp<std::size_t>(96 / count, 1, 6);
}

}  // namespace

std::vector<Ball> fitCover(const FitProblem& problem, std::size_t count, std::uint64_t seed,
                           FitMonitor& monitor) {
  constexpr std::size_t mostAttempts = 6000;
  constexpr int denseRounds = 4;
  constexpr double leastGain = 0.002, searchEnds = 0.7;
  const std::size_t attempts = std::min(20 * count + 500, mostAttempts);
  const std::size_t starts = startsFor(count);
  const std::size_t window = std::max<std::size_t>(starts > 1 ? 128 : 320, 4 * count);

  std::optional<CoverSearch> best;
  for (std::size_t start = 0; start < starts && !(best && monitor.mustStop()); ++start) {
    const double from = searchEnds * double(start) / double(starts);
    const double to = searchEnds * double(start + 1) / double(starts);
    monitor.beginPhase("cluster", from, from + (to - from) / 8);
    CoverSearch search(problem, count, seed + start, monitor);
    if (count <= fewBalls) search.polishFits();
    search.cluster();
    monitor.beginPhase("teleport", from + (to - from) / 8, to);
    search.teleport({attempts, window, leastGain});
    if (!best || search.cost() < best->cost()) best.emplace(std::move(search));
    monitor.compareWith(best->error());
  }
  monitor.compareWith(std::nullopt);
  for (int round = 0; round < denseRounds; ++round) {
    const double step = (1 - searchEnds) / denseRounds;
    monitor.beginPhase("settle", searchEnds + round * step, searchEnds + (round + 1) * step);
    if (round + 1 == denseRounds) best->polishFits();
    best->takeUpDemanded();
    best->teleport({attempts / 16, attempts, 0});
    best->report(1);
  }
  return best->balls();
}

}  // namespace haarlight
