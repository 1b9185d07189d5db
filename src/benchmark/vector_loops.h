#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace haarlight::benchmark {

/// A cache line.
struct alignas(64) MemoryBlock {
  std::array<std::uint32_t, 16> words{};
};

/// The loops that a processor's ceilings are measured with, in vectors of one width. Results depend
/// on all that is done, so that no compiler can leave a part out.
struct VectorLoops {
  const char* instructions;
  /// Copies with ordinary loads and stores, `passes` times over. `blocks`: a multiple of 8.
  void (*copy)(MemoryBlock* to, const MemoryBlock* from, std::size_t blocks, std::size_t passes);
  /// Loads all words, `passes` times over, and returns those of all lanes joined by OR.
  std::uint32_t (*read)(const MemoryBlock* from, std::size_t blocks, std::size_t passes);
  /// joinsPerPass ORs of 32-bit words a pass, from and to registers.
  std::uint32_t (*join)(std::uint32_t seed, std::size_t passes);
  /// x ← x · factor + term: multiplyAddsPerPass of them a pass, in float32, from and to registers.
  float (*multiplyAdd)(float factor, float term, std::size_t passes);
  double joinsPerPass;
  double multiplyAddsPerPass;
};

/// Those that this processor can run, the widest last.
std::vector<VectorLoops> usableVectorLoops();

}  // namespace haarlight::benchmark
