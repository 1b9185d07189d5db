#pragma once

#include <span>
#include <type_traits>

#include "sh/quadrature.h"
#include "sh/vector.h"

namespace haarlight {

/// Projects a function of direction: Σ weight · f(direction) · y(direction) over the rule's
/// directions. f(glm::dvec3) gives a double or a glm::dvec3 (RGB).
///
/// With stratifiedSphere(N, seed) this is a Monte-Carlo estimate with weight 4π/N²; with
/// productRule(degree) it is exact for an f of order k when degree ≥ k + order − 2. Throws
/// std::invalid_argument for a wrong order.
template <typename Function>
auto projectToSh(int order, std::span<const WeightedDirection> rule, const Function& f) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Function, glm::dvec3>>;
  ShVector<Value> result(order);
  ShVector<double> basis(order);
  for (const auto& [direction, weight] : rule) {
    evaluateShBasis<double>(order, direction, basis.coefficients());
    const Value value = f(direction) * weight;
    for (int i = 0; i < result.size(); ++i) result[i] += value * basis[i];
  }
  return result;
}

}  // namespace haarlight
