#include "spheres/powell.h"

#include <nlopt.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace haarlight {

namespace {

using Cost = std::function<double(std::span<const double>)>;

/// Remembers the best place, since NLopt loses it where rounding ends its search.
struct Search {
  const Cost& cost;
  std::vector<double> bestPlace;
  double bestCost = std::numeric_limits<double>::infinity();
};

double evaluate(unsigned count, const double* place, double*, void* data) {
  Search& search = *static_cast<Search*>(data);
  const double cost = search.cost({place, count});
  if (cost < search.bestCost) {
    search.bestCost = cost;
    search.bestPlace.assign(place, place + count);
  }
  return cost;
}

}  // namespace

double minimizeByPowell(std::span<double> place, const Cost& cost, const PowellOptions& options) {
  const auto count = static_cast<unsigned>(place.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
      nlopt_create(NLOPT_LN_BOBYQA, count), nlopt_destroy);
  Search search{cost, {place.begin(), place.end()}};
  nlopt_set_min_objective(optimizer.get(), evaluate, &search);
  nlopt_set_initial_step1(optimizer.get(), options.firstStep);
  nlopt_set_xtol_abs1(optimizer.get(), options.smallestStep);
  nlopt_set_maxeval(optimizer.get(), options.mostEvaluations);
  std::vector<double> current(place.begin(), place.end());
  double last = 0;
  nlopt_optimize(optimizer.get(), current.data(), &last);
  std::ranges::copy(search.bestPlace, place.begin());
  return search.bestCost;
}

}  // namespace haarlight
