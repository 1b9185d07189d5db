#pragma once

#include <optional>

namespace haarlight::benchmark {

/// Frames per second of the paper (its Table 2, method.md §6) on an Intel Core 2 with 2.4 GHz and
/// a GeForce 8800 GTX, at 16,384 samples.
struct PaperFigures {
  double cpu = 0;
  /// GPU-I for one level of visibility, GPU-II for two.
  double gpu = 0;
};

/// Nothing for settings that the paper does not have.
std::optional<PaperFigures> paperFigures(int spheres, int terms, int levels);

}  // namespace haarlight::benchmark
