#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "engine/cuda/host_emulation.h"

using namespace haarlight;

namespace {

using namespace host_emulation;

constexpr unsigned threads = 64;

/// Results of a kernel for every thread of every block; it is given the place of its result.
template <typename Result, typename Kernel>
std::vector<Result> run(std::size_t blocks, const Kernel& kernel) {
  std::vector<Result> results(blocks * threads);
  runBlocks("test", blocks, {threads, 1, 1},
            [&] { kernel(results[blockIdx.x * threads + threadIdx.x]); });
  return results;
}

__global__ void reverseNumbers(unsigned& result) {
  __shared__ unsigned numbers[threads];
  numbers[threadIdx.x] = 1000 * blockIdx.x + threadIdx.x;
  __syncthreads();
  result = numbers[threads - 1 - threadIdx.x];
}

/// Takes what the thread at this distance has written, without waiting for it.
__global__ void takeFromNeighbour(int distance, unsigned& result) {
  __shared__ unsigned numbers[threads];
  NEW_SHARED_MEMORY(numbers);
  numbers[threadIdx.x] = threadIdx.x;
  result = numbers[(int(threadIdx.x) + distance + int(threads)) % int(threads)];
}

/// Adds numbers in a tree, as the triple product does.
__global__ void addNumbers(unsigned& result) {
  __shared__ unsigned sums[threads];
  sums[threadIdx.x] = blockIdx.x + threadIdx.x;
  __syncthreads();
  for (unsigned width = threads / 2; width > 0; width /= 2) {
    if (threadIdx.x < width) sums[threadIdx.x] += sums[threadIdx.x + width];
    __syncthreads();
  }
  result = sums[0];
}

/// Reads shared memory that no thread of its block has written, and leaves something there.
__global__ void readUnwritten(float& result) {
  __shared__ float numbers[threads];
  NEW_SHARED_MEMORY(numbers);
  result = numbers[threadIdx.x];
  __syncthreads();
  numbers[threadIdx.x] = 1;
}

/// Only the first threads of block 5 come to the barrier.
__global__ void diverge() {
  if (blockIdx.x != 5 || threadIdx.x < 3) __syncthreads();
}

void checkTreeSums() {
  const auto sums = run<unsigned>(500, addNumbers);
  for (unsigned i = 0; i < sums.size(); ++i)
    REQUIRE(sums[i] == threads * (i / threads) + threads * (threads - 1) / 2);
}

class ThreadCount {
 public:
  explicit ThreadCount(unsigned count) { setThreadCount(count); }
  ~ThreadCount() { setThreadCount(0); }
};

}  // namespace

TEST_CASE("emulation: every thread of a block of any shape runs once, under its own index") {
  const Index3 shape{3, 4, 2};
  std::vector<int> runs(10 * 24);
  runBlocks("test", 10, shape, [&] {
    ++runs[blockIdx.x * 24 + (threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x];
  });
  CHECK(runs == std::vector<int>(10 * 24, 1));
}

TEST_CASE("emulation: what was written before a barrier is read after it") {
  const auto numbers = run<unsigned>(100, reverseNumbers);
  for (unsigned i = 0; i < numbers.size(); ++i)
    REQUIRE(numbers[i] == 1000 * (i / threads) + threads - 1 - i % threads);
}

TEST_CASE("emulation: a missing barrier shows, whichever neighbour a thread reads from") {
  for (const int distance : {-1, 1}) {
    CAPTURE(distance);
    const auto numbers =
        run<unsigned>(2, [&](unsigned& result) { takeFromNeighbour(distance, result); });
    // The neighbour that runs earlier: block 0 goes upwards, block 1 downwards.
    const unsigned fortunate = distance < 0 ? 0 : 1;
    for (unsigned thread = 1; thread + 1 < threads; ++thread) {
      REQUIRE(numbers[fortunate * threads + thread] == unsigned(int(thread) + distance));
      REQUIRE(numbers[(1 - fortunate) * threads + thread] == 0xffffffff);
    }
  }
}

TEST_CASE("emulation: many barriers, and blocks on several host threads share no memory") {
  for (const unsigned count : {1u, 4u}) {
    const ThreadCount threadCount(count);
    checkTreeSums();
  }
}

TEST_CASE("emulation: a block finds NaN in its shared memory, not what another one left") {
  for (const float number : run<float>(50, readUnwritten)) REQUIRE(std::isnan(number));
}

TEST_CASE("emulation: threads that end while others wait are reported, and do not spoil the next") {
  CHECK_THROWS_WITH_AS(runBlocks("diverge", 10, {threads, 1, 1}, diverge),
                       "kernel diverge: 61 threads of block 5 ended while 3 waited at a barrier",
                       std::logic_error);
  checkTreeSums();
}

TEST_CASE("emulation: blocks may grow and shrink from launch to launch") {
  for (const unsigned size : {8u, 256u, 32u}) {
    std::vector<unsigned> counts(4 * size);
    runBlocks("test", 4, {size, 1, 1}, [&] {
      unsigned& own = counts[blockIdx.x * size + threadIdx.x];
      for (int i = 0; i < 3; ++i, __syncthreads()) ++own;
    });
    CHECK(counts == std::vector<unsigned>(4 * size, 3));
  }
}

TEST_CASE("emulation: __fmaf_rn rounds once") {
  // (1 + 2^-12)^2 = 1 + 2^-11 + 2^-24, whose last term is lost when the product is rounded.
  const float factor = 1 + 0x1p-12f, rounded = 1 + 0x1p-11f;
  CHECK(factor * factor == rounded);
  CHECK(__fmaf_rn(factor, factor, -rounded) == 0x1p-24f);
}

TEST_CASE("emulation: vectors are laid out as CUDA's") {
  CHECK(sizeof(float4) == 16);
  CHECK(alignof(float4) == 16);
  CHECK(sizeof(uint4) == 16);
  CHECK(alignof(uint4) == 16);
}
