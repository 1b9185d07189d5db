#include "shadow/octree_refinement.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"

namespace haarlight {

namespace {

/// A caster that may shadow a part of a cell, but not all of it, as far as is known.
struct Suspect {
  std::uint32_t caster;
  Parts parts;
  CellShadow shadow = CellShadow::unknown;
  std::size_t rays = 0;  ///< how many of the cell's rays ask about it
};

/// What a cell hands down to its children.
struct CellState {
  Parts surface;
  std::vector<Suspect> suspects;
  std::optional<bool> inShadow;  ///< once it is known
};

struct Task {
  CellCode cell;
  std::shared_ptr<const CellState> parent;
};

struct Outcome {
  bool isReached = false;
  bool byRay = false;
  CellState state;
  std::vector<OcclusionRay> rays;
};

/// By how much cells are larger when they are looked at, as a part of the octree's edge, so that
/// rounding cannot put a point of the surface beside its cell.
constexpr double relativeGrowth = 1e-6;

class Refinement {
 public:
  Refinement(const ShadowScene& scene, std::uint32_t receiver, const OctreeDepths& depths,
             OctreeCounts& counts)
      : scene_(scene),
        receiver_(receiver),
        object_(*scene.objects[receiver]),
        depths_(depths),
        counts_(counts),
        bounds_(object_.bounds()) {}

  ShadowOctree build(std::span<const std::uint32_t> casters) {
    if (bounds_.isEmpty()) return {};
    cube_ = OctreeCube(bounds_);
    growth_ = relativeGrowth * cube_.edge + object_.tolerance();
    std::vector<Task> tasks{{CellCode{}, std::make_shared<CellState>(rootState(casters))}};
    while (!tasks.empty()) tasks = divide(tasks);
    Stopwatch watch;
    ShadowOctree octree(cube_, std::move(leaves_));
    counts_.sortSeconds += watch.lap();
    return octree;
  }

 private:
  CellState rootState(std::span<const std::uint32_t> casters) {
    CellState state;
    state.surface = object_.surfaceParts();
    bool hasItself = false;
    for (const std::uint32_t caster : casters) {
      castersBox_ = united(castersBox_, scene_.objects[caster]->bounds());
      hasItself = hasItself || caster == receiver_;
      if (caster != receiver_)
        state.suspects.push_back({caster, scene_.objects[caster]->casterParts()});
    }
    if (hasItself) state.suspects.push_back({receiver_, object_.casterParts()});
    return state;
  }

  /// The next level's cells.
  std::vector<Task> divide(const std::vector<Task>& tasks) {
    Stopwatch watch;
    std::vector<Outcome> outcomes(tasks.size());
    constexpr std::size_t grain = 32;
    parallelFor(tasks.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) outcomes[i] = look(tasks[i]);
    });
    counts_.proofSeconds += watch.lap();
    castRays(outcomes, tasks.front().cell.depth == depths_.boundary);
    counts_.raySeconds += watch.lap();
    std::vector<Task> next;
    for (std::size_t i = 0; i < tasks.size(); ++i) finish(tasks[i].cell, outcomes[i], next);
    counts_.proofSeconds += watch.lap();
    return next;
  }

  /// A cell without what lies beyond the receiver's box, and a little larger.
  AxisBox boxOf(const CellCode& cell) const {
    const AxisBox box = cube_.box(cell);
    const AxisBox part{glm::max(box.lower, bounds_.lower), glm::min(box.upper, bounds_.upper)};
    if (part.isEmpty()) return part;
    return {part.lower - growth_, part.upper + growth_};
  }

  Outcome look(const Task& task) const {
    Outcome outcome;
    const AxisBox cell = boxOf(task.cell);
    if (cell.isEmpty()) return outcome;
    outcome.state.surface = task.parent->surface;
    outcome.isReached = object_.surfaceReaches(cell, outcome.state.surface);
    if (!outcome.isReached) return outcome;
    outcome.state.inShadow = task.parent->inShadow;
    if (outcome.state.inShadow) return outcome;
    judge(task.parent->suspects, Shaft(cell, scene_.light, castersBox_), outcome.state);
    if (!outcome.state.inShadow) askRays(cell, task.cell.depth == depths_.boundary, outcome);
    return outcome;
  }

  /// Leaves those suspects of which something remains unknown. The receiver comes last.
  void judge(const std::vector<Suspect>& suspects, const Shaft& shaft, CellState& state) const {
    for (const Suspect& inherited : suspects) {
      const bool isItself = inherited.caster == receiver_;
      const bool isAttached = isItself && !object_.castsOnItself();
      if (isAttached && state.suspects.empty()) break;  // the normal tells as much
      Suspect suspect{inherited.caster, inherited.parts};
      suspect.shadow = isItself ? object_.ownShadowOn(shaft, suspect.parts)
                                : scene_.objects[suspect.caster]->shadowOn(shaft, suspect.parts);
      if (suspect.shadow == CellShadow::all) {
        state.inShadow = true;
        return;
      }
      if (suspect.shadow != CellShadow::none || isAttached)
        state.suspects.push_back(std::move(suspect));
    }
    if (state.suspects.empty()) state.inShadow = false;
  }

  bool isRaysBusiness(const Suspect& suspect) const {
    return suspect.caster != receiver_ || object_.castsOnItself();
  }

  /// Before the last depth, those that tell all about a suspect; then one for each.
  void askRays(const AxisBox& cell, bool isLast, Outcome& outcome) const {
    const Parts& surface = outcome.state.surface;
    for (Suspect& suspect : outcome.state.suspects) {
      const bool isUniform = suspect.shadow == CellShadow::uniform;
      if (!isRaysBusiness(suspect) || !(isUniform || isLast)) continue;
      outcome.byRay = outcome.byRay || !isUniform;
      const bool isItself = suspect.caster == receiver_;
      std::vector<glm::dvec3> points;
      if (isItself)
        points = object_.ownPoints(cell, surface);
      else
        points = {isLast ? object_.surfacePoint(cell, surface) : cell.center()};
      if (isLast) points.resize(1);
      for (const glm::dvec3& point : points)
        outcome.rays.push_back({point, suspect.caster, isItself});
      suspect.rays = points.size();
    }
  }

  /// Answers the rays of all cells of a level at once.
  void castRays(std::vector<Outcome>& outcomes, bool isLast) {
    std::vector<OcclusionRay> rays;
    for (const Outcome& outcome : outcomes)
      rays.insert(rays.end(), outcome.rays.begin(), outcome.rays.end());
    counts_.rays += rays.size();
    std::vector<std::uint8_t> blocked(rays.size());
    if (!rays.empty()) scene_.rays.answer(rays, blocked);
    std::span<const std::uint8_t> rest(blocked);
    for (Outcome& outcome : outcomes) {
      const std::size_t count = outcome.rays.size();
      if (isLast && !outcome.state.suspects.empty() && !outcome.state.inShadow)
        outcome.state.inShadow = std::ranges::count(rest.first(count), 1) > 0;
      else if (count > 0)
        sortOut(outcome.state, rest.first(count));
      rest = rest.subspan(count);
    }
  }

  /// Draws the conclusions from the rays of those suspects of which one ray tells all.
  void sortOut(CellState& state, std::span<const std::uint8_t> blocked) const {
    std::vector<Suspect> left;
    bool isOpen = false;
    for (Suspect& suspect : state.suspects) {
      const auto answers = blocked.first(suspect.rays);
      blocked = blocked.subspan(suspect.rays);
      const auto hits = std::size_t(std::ranges::count(answers, 1));
      if (suspect.rays > 0 && hits == suspect.rays) {
        state.inShadow = true;
        return;
      }
      if (suspect.rays > 0 && hits == 0) continue;
      isOpen = isOpen || isRaysBusiness(suspect);
      suspect.rays = 0;
      left.push_back(std::move(suspect));
    }
    state.suspects = std::move(left);
    if (!isOpen) state.inShadow = false;
  }

  /// Makes a leaf, or divides.
  void finish(const CellCode& cell, Outcome& outcome, std::vector<Task>& next) {
    ++counts_.cells[cell.depth];
    if (!outcome.isReached) {
      ++counts_.unreached[cell.depth];
      return;
    }
    const auto& inShadow = outcome.state.inShadow;
    if (inShadow && cell.depth >= depths_.interior) {
      const bool byRay = cell.depth == depths_.boundary && outcome.byRay;
      leaves_.push_back({cell, *inShadow, byRay});
      ++(*inShadow ? counts_.inShadow : counts_.inLight)[cell.depth];
      counts_.byRay += byRay;
      return;
    }
    const auto state = std::make_shared<CellState>(std::move(outcome.state));
    for (std::uint32_t i = 0; i < 8; ++i) next.push_back({cell.child(i), state});
  }

  const ShadowScene& scene_;
  std::uint32_t receiver_;
  const ShadowObject& object_;
  OctreeDepths depths_;
  OctreeCounts& counts_;
  AxisBox bounds_, castersBox_;
  OctreeCube cube_;
  double growth_ = 0;
  std::vector<ShadowLeaf> leaves_;
};

}  // namespace

void checkDepths(const OctreeDepths& depths) {
  if (depths.interior < 0 || depths.interior > depths.boundary || depths.boundary > deepestCell)
    throw InputError("octree depths must be 0 ≤ interior ≤ boundary ≤ " +
                     std::to_string(deepestCell) + ", but are " + std::to_string(depths.interior) +
                     " and " + std::to_string(depths.boundary));
}

OctreeCounts& OctreeCounts::operator+=(const OctreeCounts& other) {
  const auto add = [](ByDepth& sum, const ByDepth& more) {
    for (std::size_t depth = 0; depth < sum.size(); ++depth) sum[depth] += more[depth];
  };
  add(cells, other.cells);
  add(unreached, other.unreached);
  add(inShadow, other.inShadow);
  add(inLight, other.inLight);
  byRay += other.byRay;
  rays += other.rays;
  proofSeconds += other.proofSeconds;
  raySeconds += other.raySeconds;
  sortSeconds += other.sortSeconds;
  return *this;
}

ShadowOctree buildShadowOctree(const ShadowScene& scene, std::uint32_t receiver,
                               std::span<const std::uint32_t> casters, const OctreeDepths& depths,
                               OctreeCounts& counts) {
  checkDepths(depths);
  return Refinement(scene, receiver, depths, counts).build(casters);
}

std::vector<std::vector<std::uint32_t>> castersByReceiver(std::span<const ShadowPair> pairs,
                                                          std::size_t count) {
  std::vector<std::vector<std::uint32_t>> result(count);
  for (const auto& [caster, receiver] : pairs) result[receiver].push_back(caster);
  return result;
}

}  // namespace haarlight
