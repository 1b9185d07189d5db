#include "benchmark/ceilings.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "benchmark/vector_loops.h"

using namespace haarlight;
using namespace haarlight::benchmark;

namespace {

std::vector<MemoryBlock> numbered(std::size_t blocks) {
  std::vector<MemoryBlock> memory(blocks);
  std::uint32_t number = 0;
  for (MemoryBlock& block : memory)
    for (std::uint32_t& word : block.words) word = ++number;
  return memory;
}

}  // namespace

TEST_CASE("loops copy every word, whatever the width of vectors") {
  const auto from = numbered(24);
  for (const VectorLoops& loops : usableVectorLoops()) {
    CAPTURE(loops.instructions);
    std::vector<MemoryBlock> to(25);
    loops.copy(to.data(), from.data(), 24, 2);
    for (std::size_t i = 0; i < from.size(); ++i) CHECK(to[i].words == from[i].words);
    CHECK(to.back().words == MemoryBlock{}.words);
  }
}

TEST_CASE("loops read every word and no other") {
  for (const VectorLoops& loops : usableVectorLoops()) {
    CAPTURE(loops.instructions);
    std::vector<MemoryBlock> memory(9);
    memory.back().words.fill(~0u);  // not to be read
    for (std::size_t word = 0; word < 8 * 16; ++word) {
      std::uint32_t& place = memory[word / 16].words[word % 16];
      place = 1u << word % 32;
      CHECK(loops.read(memory.data(), 8, 3) == place);
      place = 0;
    }
  }
}

TEST_CASE("loops join and multiply as often as they say") {
  for (const VectorLoops& loops : usableVectorLoops()) {
    CAPTURE(loops.instructions);
    CHECK(loops.join(1, 1) == 0xff);  // chains start with bits 0 … 7
    const double lanes = loops.joinsPerPass / 8;
    CHECK(std::fmod(lanes, 4) == 0);
    // Chain k starts with k · term; after n passes it is k · term · factor^n + term (1 + … ).
    const int passes = 3;
    const float factor = 2, term = 3;
    double sum = 0;
    const int chains = int(loops.multiplyAddsPerPass / lanes);
    for (int k = 0; k < chains; ++k)
      sum += lanes * (k * term * std::pow(factor, passes) + term * (std::pow(factor, passes) - 1));
    CHECK(loops.multiplyAdd(factor, term, passes) == doctest::Approx(sum));
  }
}

TEST_CASE("sets of memory grow from level to level, and RAM takes what the others do not hold") {
  for (const unsigned threads : {1u, 2u, 64u}) {
    const CeilingPlan plan = ceilingPlan(threads);
    REQUIRE(plan.memory.size() == 4);
    CHECK(std::ranges::is_sorted(plan.memory, {}, &MemoryCeiling::bytesPerThread));
    CHECK(std::ranges::is_sorted(plan.memory, {}, &MemoryCeiling::holdsBytes));
    CHECK(std::isinf(plan.memory.back().holdsBytes));
    for (const MemoryCeiling& level : plan.memory) CHECK(level.bytesPerThread % 1024 == 0);
    CHECK(plan.memory.back().bytesPerThread * threads >= 256 << 20);
  }
  CHECK(ceilingPlan(2).memory[0].bytesPerThread == 16 << 10);
  CHECK(ceilingPlan(2).memory[3].bytesPerThread == 128 << 20);
}

TEST_CASE("a short run measures every ceiling") {
  const CeilingPlan plan{.threads = threadCount(),
                         .memory = {{"L1", 2048, 4096, 0, 0}, {"L2", 8192, 16384, 0, 0}},
                         .seconds = 1e-4,
                         .rounds = 2};
  double last = 0;
  const Ceilings ceilings = measureCeilings(plan, [&](const std::string&, double finished) {
    CHECK(finished > last);
    last = finished;
  });
  CHECK(last == 1);
  CHECK(ceilings.threads == threadCount());
  CHECK_FALSE(ceilings.instructions.empty());
  REQUIRE(ceilings.memory.size() == 2);
  for (const MemoryCeiling& level : ceilings.memory) {
    CHECK(level.copy > 0);
    CHECK(level.read > 0);
    CHECK(level.fastest() == std::max(level.copy, level.read));
  }
  CHECK(ceilings.memory[1].name == "L2");
  CHECK(ceilings.operations() == std::max(ceilings.joins, ceilings.multiplyAdds));
  CHECK(std::min(ceilings.joins, ceilings.multiplyAdds) > 0);
}
