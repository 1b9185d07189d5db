#include "benchmark/quartiles.h"

#include <algorithm>

namespace haarlight::benchmark {

Quartiles quartilesOf(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  const std::size_t count = seconds.size();
  return {count, seconds.front(), seconds[count / 4], seconds[count / 2], seconds[3 * count / 4]};
}

}  // namespace haarlight::benchmark
