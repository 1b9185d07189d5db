#pragma once

#include <array>

namespace haarlight {

/// Float32 sums of all engines follow one order (docs/numerics.md): term k of a list is added to
/// partial sum k mod 32, by fma where it is a product; the partial sums are then added as a tree of
/// halves: 16, 8, 4, 2, 1.
inline constexpr int partialSums = 32;

/// The tree over the partial results; `combine` is + for sums.
template <typename Value, typename Combine>
Value combineAsTree(std::array<Value, partialSums> partials, const Combine& combine) {
  for (int half = partialSums / 2; half > 0; half /= 2)
    for (int i = 0; i < half; ++i) partials[i] = combine(partials[i], partials[i + half]);
  return partials[0];
}

}  // namespace haarlight
