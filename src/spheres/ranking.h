#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "mesh/random.h"

namespace haarlight {

/// function(0) … function(count − 1), found on all threads.
template <typename Result, typename Function>
std::vector<Result> computeForAll(std::size_t count, const Function& function) {
  constexpr std::size_t mostRanges = 256;
  std::vector<Result> results(count);
  parallelFor(count, count / mostRanges + 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) results[i] = function(i);
  });
  return results;
}

/// The places sorted by a value each; ties in order of place.
inline std::vector<std::size_t> smallestFirst(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}
inline std::vector<std::size_t> largestFirst(std::vector<double> values) {
  for (double& value : values) value = -value;
  return smallestFirst(values);
}

/// One of `order`, the earlier the likelier: at part u^power for a random u.
inline std::size_t pickEarly(const std::vector<std::size_t>& order, int power, Random& random) {
  return order[std::size_t(std::pow(random.uniform(), power) * double(order.size()))];
}

}  // namespace haarlight
