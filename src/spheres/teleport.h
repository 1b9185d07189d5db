#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "spheres/fit_monitor.h"

namespace haarlight {

/// How long to try.
struct TeleportPlan {
  std::size_t attempts;
  /// It ends where this many attempts have lowered the cost by less than the part `leastGain`.
  std::size_t window;
  double leastGain;
};

/// Improves a state by attempts on copies of it, of which the best is kept where it costs less
/// (teleportation, Wang et al. 2006, §4.3). Attempts run on all threads, in batches of a fixed
/// size, so that the result does not depend on their number.
///
/// propose(state) gives what to attempt; apply(copy, proposal) does it; cost(state) rates;
/// accepted() is called after each improvement.
template <typename State, typename Propose, typename Apply, typename Cost, typename Accepted>
void improveByTeleports(State& state, const TeleportPlan& plan, FitMonitor& monitor,
                        const Propose& propose, const Apply& apply, const Cost& cost,
                        const Accepted& accepted) {
  constexpr std::size_t batch = 8;
  double costBefore = cost(state);
  std::size_t sinceThen = 0;
  for (std::size_t done = 0; done < plan.attempts && !monitor.mustStop(); done += batch) {
    std::vector<decltype(propose(state))> proposals;
    while (proposals.size() < batch) proposals.push_back(propose(state));
    std::vector<std::optional<State>> results(batch);
    parallelFor(batch, 1, [&](std::size_t i, std::size_t) {
      results[i] = state;
      apply(*results[i], proposals[i]);
    });
    const auto best = std::ranges::min_element(
        results, {}, [&](const std::optional<State>& result) { return cost(*result); });
    if (cost(**best) < cost(state)) {
      state = std::move(**best);
      accepted();
    }
    monitor.report(double(done + batch) / double(plan.attempts), state.balls().size(), cost(state));
    if ((sinceThen += batch) < plan.window) continue;
    if (cost(state) > costBefore * (1 - plan.leastGain)) break;
    costBefore = cost(state);
    sinceThen = 0;
  }
}

}  // namespace haarlight
