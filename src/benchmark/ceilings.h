#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/progress.h"

namespace haarlight::benchmark {

/// How fast a machine's threads, all at once, go again and again over sets of memory of one size.
struct MemoryCeiling {
  /// "L1", "L2", "L3" or "RAM".
  std::string name;
  /// Of each thread's own set; half of it is copied to the other half.
  std::size_t bytesPerThread = 0;
  /// Sets up to this size are taken to lie there: twice what was measured, since caches are larger
  /// than that, of all threads where they share it. Infinite for RAM.
  double holdsBytes = 0;
  /// Bytes per second of all threads; those copied count twice, once read and once written.
  double copy = 0, read = 0;

  double fastest() const { return copy > read ? copy : read; }
};

/// The most that the processor does in a second, on all threads, as measured.
struct Ceilings {
  unsigned threads = 0;
  /// The vectors that loops were written in.
  std::string instructions;
  /// From the nearest to the farthest.
  std::vector<MemoryCeiling> memory;
  /// ORs of 32-bit words, from registers to registers.
  double joins = 0;
  /// Floating point operations of fused multiply-adds in float32: two for each.
  double multiplyAdds = 0;

  /// No kernel does more operations on 32-bit lanes.
  double operations() const { return joins > multiplyAdds ? joins : multiplyAdds; }
};

/// What is measured and for how long.
struct CeilingPlan {
  unsigned threads = 1;
  /// Name, bytesPerThread (a multiple of 1 KiB) and holdsBytes.
  std::vector<MemoryCeiling> memory;
  /// What is done once takes at least this long: short, so that other programs leave some of it
  /// alone, and far longer than it takes to start threads.
  double seconds = 0.005;
  /// It is done once more in each round over everything. The best counts.
  int rounds = 60;
};

/// 16 KiB, 512 KiB and 4 MiB a thread, and 256 MiB in all (16 MiB a thread where that is more):
/// sets that fit L1, L2, a thread's share of L3, and none of them. Takes about five seconds.
CeilingPlan ceilingPlan(unsigned threads);

/// Measures with parallelFor, whose thread count has to be the plan's.
Ceilings measureCeilings(const CeilingPlan& plan, const Progress& progress);

}  // namespace haarlight::benchmark
