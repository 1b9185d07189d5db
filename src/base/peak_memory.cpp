#include "base/peak_memory.h"

#include <sys/resource.h>

namespace haarlight {

double peakMemoryMebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

}  // namespace haarlight
