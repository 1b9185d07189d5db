#include "benchmark/vector_loops.h"

namespace haarlight::benchmark {

namespace {

constexpr int vectorsAtOnce = 8;
/// Enough chains to hide latency, few enough for 16 registers.
constexpr int joinChains = 8, multiplyAddChains = 12;

template <int bytes>
struct Vectors {
  typedef std::uint32_t Words __attribute__((vector_size(bytes), may_alias));
  typedef float Floats __attribute__((vector_size(bytes)));
  static constexpr int lanes = bytes / 4;
};

/// All chains in one word.
template <int bytes, int count>
[[gnu::always_inline]] inline std::uint32_t joined(
    const typename Vectors<bytes>::Words (&chains)[count]) {
  typename Vectors<bytes>::Words lanes = chains[0];
  for (int i = 1; i < count; ++i) lanes |= chains[i];
  std::uint32_t all = 0;
  for (int lane = 0; lane < Vectors<bytes>::lanes; ++lane) all |= lanes[lane];
  return all;
}

template <int bytes>
[[gnu::always_inline]] inline void copyLoop(MemoryBlock* to, const MemoryBlock* from,
                                            std::size_t blocks, std::size_t passes) {
  using Words = typename Vectors<bytes>::Words;
  const std::size_t count = blocks * (sizeof(MemoryBlock) / bytes);
  const auto* source = reinterpret_cast<const Words*>(from);
  auto* target = reinterpret_cast<Words*>(to);
  for (std::size_t pass = 0; pass < passes; ++pass)
    for (std::size_t i = 0; i < count; i += vectorsAtOnce) {
      for (int j = 0; j < vectorsAtOnce; ++j) target[i + j] = source[i + j];
      // Otherwise the loop becomes a call of memcpy, whose stores may pass the caches by.
      asm volatile("" ::: "memory");
    }
}

template <int bytes>
[[gnu::always_inline]] inline std::uint32_t readLoop(const MemoryBlock* from, std::size_t blocks,
                                                     std::size_t passes) {
  using Words = typename Vectors<bytes>::Words;
  const std::size_t count = blocks * (sizeof(MemoryBlock) / bytes);
  const auto* source = reinterpret_cast<const Words*>(from);
  Words chains[vectorsAtOnce] = {};
  for (std::size_t pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < count; i += vectorsAtOnce)
      for (int j = 0; j < vectorsAtOnce; ++j) chains[j] |= source[i + j];
    asm volatile("" : "+r"(source));  // it may point elsewhere now, so that every pass has to load
  }
  return joined<bytes>(chains);
}

/// Each chain takes in the next one, so that no OR is without effect.
template <int bytes>
[[gnu::always_inline]] inline std::uint32_t joinLoop(std::uint32_t seed, std::size_t passes) {
  using Words = typename Vectors<bytes>::Words;
  Words chains[joinChains];
  for (int i = 0; i < joinChains; ++i) chains[i] = (seed << i) - Words{};
  for (std::size_t pass = 0; pass < passes; ++pass)
    for (int i = 0; i < joinChains; ++i) chains[i] |= chains[(i + 1) % joinChains];
  return joined<bytes>(chains);
}

template <int bytes>
[[gnu::always_inline]] inline float multiplyAddLoop(float factor, float term, std::size_t passes) {
  using Floats = typename Vectors<bytes>::Floats;
  const Floats factors = factor - Floats{}, terms = term - Floats{};
  Floats chains[multiplyAddChains];
  for (int i = 0; i < multiplyAddChains; ++i) chains[i] = terms * float(i);
  for (std::size_t pass = 0; pass < passes; ++pass)
    for (Floats& chain : chains) chain = chain * factors + terms;
  Floats lanes = chains[0];
  for (int i = 1; i < multiplyAddChains; ++i) lanes += chains[i];
  float sum = 0;
  for (int lane = 0; lane < Vectors<bytes>::lanes; ++lane) sum += lanes[lane];
  return sum;
}

/// The loops for vectors of `bytes` bytes, compiled for processors that have `features`.
#define HAARLIGHT_VECTOR_LOOPS(name, bytes, features)                                       \
  struct name {                                                                             \
    features static void copy(MemoryBlock* to, const MemoryBlock* from, std::size_t blocks, \
                              std::size_t passes) {                                         \
      copyLoop<bytes>(to, from, blocks, passes);                                            \
    }                                                                                       \
    features static std::uint32_t read(const MemoryBlock* from, std::size_t blocks,         \
                                       std::size_t passes) {                                \
      return readLoop<bytes>(from, blocks, passes);                                         \
    }                                                                                       \
    features static std::uint32_t join(std::uint32_t seed, std::size_t passes) {            \
      return joinLoop<bytes>(seed, passes);                                                 \
    }                                                                                       \
    features static float multiplyAdd(float factor, float term, std::size_t passes) {       \
      return multiplyAddLoop<bytes>(factor, term, passes);                                  \
    }                                                                                       \
    static VectorLoops loops(const char* instructions) {                                    \
      return {instructions,                                                                 \
              copy,                                                                         \
              read,                                                                         \
              join,                                                                         \
              multiplyAdd,                                                                  \
              joinChains * Vectors<bytes>::lanes,                                           \
              multiplyAddChains * Vectors<bytes>::lanes};                                   \
    }                                                                                       \
  };

HAARLIGHT_VECTOR_LOOPS(Common, 16, )
#ifdef __x86_64__
HAARLIGHT_VECTOR_LOOPS(Avx2, 32, __attribute__((target("avx2,fma"))))
HAARLIGHT_VECTOR_LOOPS(Avx512, 64, __attribute__((target("avx512f,fma"))))
#endif
#undef HAARLIGHT_VECTOR_LOOPS

}  // namespace

std::vector<VectorLoops> usableVectorLoops() {
  std::vector<VectorLoops> usable{Common::loops("vectors of 16 bytes")};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    usable.push_back(Avx2::loops("AVX2"));
  if (__builtin_cpu_supports("avx512f")) usable.push_back(Avx512::loops("AVX-512"));
#endif
  return usable;
}

}  // namespace haarlight::benchmark
