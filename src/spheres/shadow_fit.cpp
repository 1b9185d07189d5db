#include "spheres/shadow_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include "mesh/mesh_measures.h"
#include "mesh/random.h"
#include "mesh/ray_scene.h"
#include "spheres/ranking.h"
#include "spheres/silhouette_cover.h"
#include "spheres/teleport.h"
#include "spheres/viewpoints.h"

namespace haarlight {

namespace {

/// Enough that what is won on them is won from between them, too: for the bunny with 64 balls the
/// error from elsewhere is a tenth above theirs.
constexpr std::size_t viewCount = 64;

constexpr std::size_t receiverCount = 8000;

/// So many that a typical ball is some pixels wide.
int pixelsFor(std::size_t count) {
  return static_cast<int>(std::clamp(48 + 6 * std::sqrt(double(count)), 64.0, 256.0));
}

std::shared_ptr<const SilhouetteCover::Views> makeViews(const TriangleMesh& mesh, int pixels,
                                                        std::uint64_t seed) {
  const RayScene scene(mesh);
  const auto eyes = viewpointsAround(boundingBox(mesh), viewCount, seed);
  auto made = computeForAll<std::optional<SilhouetteView>>(
      viewCount, [&](std::size_t i) { return SilhouetteView(mesh, scene, eyes[i], pixels); });
  auto views = std::make_shared<SilhouetteCover::Views>();
  for (auto& view : made)
    if (!view->empty()) views->push_back(std::move(*view));
  return views;
}

/// Balls around points inside that just touch the surface, and balls on the surface of a size in
/// which `count` of them would cover it, for where there is no inside.
std::vector<Ball> candidateBalls(const FitProblem& problem, std::size_t count) {
  const std::size_t wanted = std::max<std::size_t>(2000, 8 * count);
  const auto inside = problem.solid.insidePoints(wanted);
  const std::size_t step = std::max<std::size_t>(1, problem.surface.size() / (wanted / 2));
  std::vector<Ball> balls = computeForAll<Ball>(inside.size(), [&](std::size_t i) {
    const glm::dvec3 center = inside[i];
    double square = std::numeric_limits<double>::max();
    for (const glm::vec3& point : problem.surface)
      square = std::min(square, glm::dot(glm::dvec3(point) - center, glm::dvec3(point) - center));
    return Ball{center, std::sqrt(square)};
  });
  const double radius = std::sqrt(surfaceArea(problem.mesh) / (double(count) * std::numbers::pi));
  for (std::size_t i = 0; i < problem.surface.size(); i += step)
    balls.push_back({glm::dvec3(problem.surface[i]), radius / 2});
  return balls;
}

/// The ball taken away and what comes instead.
struct Move {
  std::size_t from;
  Ball to;
};

/// Puts the proposal in the ball's place where that lowers the error.
void accept(SilhouetteCover& cover, std::size_t index, const Ball& proposal) {
  const Ball old = cover.balls()[index];
  const double before = cover.error();
  cover.replace(index, proposal);
  if (!(cover.error() < before)) cover.replace(index, old);
}

/// Moves a ball, and refines it and those that are nearest to where it was and is.
void teleportBall(SilhouetteCover& cover, const Move& move) {
  constexpr std::size_t mostNeighbours = 10;
  const Ball left = cover.balls()[move.from];
  cover.replace(move.from, move.to);
  accept(cover, move.from, cover.refined(move.from));
  const Ball arrived = cover.balls()[move.from];
  const auto gap = [](const Ball& a, const Ball& b) {
    return glm::distance(a.center, b.center) - a.radius - b.radius;
  };
  std::vector<double> gaps;
  for (const Ball& ball : cover.balls())
    gaps.push_back(std::min(gap(ball, left), gap(ball, arrived)));
  const auto order = smallestFirst(gaps);
  for (std::size_t k = 0; k < std::min(mostNeighbours, order.size()); ++k)
    accept(cover, order[k], cover.refined(order[k]));
  accept(cover, move.from, cover.refined(move.from));
}

class ShadowSearch {
 public:
  ShadowSearch(const FitProblem& problem, std::size_t count, std::uint64_t seed,
               FitMonitor& monitor)
      : candidates_(candidateBalls(problem, count)),
        monitor_(monitor),
        random_(seed),
        cover_(makeViews(problem.mesh, pixelsFor(count), seed),
               std::make_shared<SurfaceReceivers>(problem.mesh, receiverCount, seed)) {}

  /// The gains of candidates only fall as balls are added, so that a candidate that is still the
  /// best when looked at again is the best.
  void addGreedily(std::size_t count) {
    updateGains();
    std::priority_queue<std::pair<double, std::size_t>> queue;
    for (std::size_t i = 0; i < gains_.size(); ++i) queue.emplace(gains_[i], i);
    while (cover_.balls().size() < count && !queue.empty() && !monitor_.mustStop()) {
      const std::size_t best = queue.top().second;
      queue.pop();
      const double gain = cover_.gainOf(candidates_[best]);
      if (!queue.empty() && gain < queue.top().first)
        queue.emplace(gain, best);
      else if (gain > 0)
        cover_.add(candidates_[best]);
      else
        break;
    }
    if (cover_.balls().empty()) cover_.add(candidates_.front());
    report(1);
  }

  void refine(int mostRounds, double leastGain, double smallestStep) {
    for (int round = 0; round < mostRounds && !monitor_.mustStop(); ++round) {
      const double before = cover_.error();
      refineEach(smallestStep);
      report(double(round + 1) / mostRounds);
      if (cover_.error() > before * (1 - leastGain)) break;
    }
  }

  void teleport(const TeleportPlan& plan) {
    if (cover_.balls().size() < 2) return;
    order();
    improveByTeleports(
        cover_, plan, monitor_, [&](const SilhouetteCover&) { return choose(); }, teleportBall,
        [](const SilhouetteCover& cover) { return cover.error(); }, [&] { order(); });
  }

  const std::vector<Ball>& balls() const { return cover_.balls(); }

 private:
  /// Every ball once, in an order without a system, some at a time.
  void refineEach(double smallestStep) {
    constexpr std::size_t batch = 8;
    std::vector<std::size_t> order(cover_.balls().size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random_.next() % i]);
    for (std::size_t begin = 0; begin < order.size() && !monitor_.mustStop(); begin += batch) {
      const auto proposals = computeForAll<Ball>(
          std::min(batch, order.size() - begin),
          [&](std::size_t i) { return cover_.refined(order[begin + i], smallestStep); });
      for (std::size_t i = 0; i < proposals.size(); ++i)
        accept(cover_, order[begin + i], proposals[i]);
    }
  }

  void updateGains() {
    gains_ = computeForAll<double>(candidates_.size(),
                                   [&](std::size_t i) { return cover_.gainOf(candidates_[i]); });
  }

  /// Candidates change little from one improvement to the next, and there are many.
  void order() {
    constexpr int improvementsBetween = 4;
    if (improvements_++ % improvementsBetween == 0) {
      updateGains();
      helpful_ = largestFirst(gains_);
    }
    needless_ = smallestFirst(computeForAll<double>(
        cover_.balls().size(), [&](std::size_t i) { return cover_.lossOf(i); }));
  }

  Move choose() {
    return {pickEarly(needless_, 2, random_), candidates_[pickEarly(helpful_, 4, random_)]};
  }

  void report(double part) { monitor_.report(part, cover_.balls().size(), cover_.error()); }

  std::vector<Ball> candidates_;
  FitMonitor& monitor_;
  Random random_;
  SilhouetteCover cover_;
  std::vector<double> gains_;  ///< of the candidates
  std::vector<std::size_t> needless_, helpful_;
  std::size_t improvements_ = 0;
};

}  // namespace

std::vector<Ball> fitShadow(const FitProblem& problem, std::size_t count, std::uint64_t seed,
                            FitMonitor& monitor) {
  constexpr std::size_t mostAttempts = 3000, fewestInWindow = 160;
  constexpr double coarseStep = 0.01, fineStep = 0.002;
  const std::size_t attempts = std::min(10 * count + 200, mostAttempts);

  monitor.beginPhase("add", 0, 0.05);
  ShadowSearch search(problem, count, seed, monitor);
  search.addGreedily(count);
  monitor.beginPhase("refine", 0.05, 0.2);
  search.refine(20, 0.01, coarseStep);
  monitor.beginPhase("teleport", 0.2, 0.9);
  search.teleport({attempts, std::max(fewestInWindow, 2 * count), 0.005});
  monitor.beginPhase("refine", 0.9, 1);
  search.refine(10, 0.002, fineStep);
  return search.balls();
}

}  // namespace haarlight
