#include "engine/cuda/host_emulation.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <stdexcept>

#include "base/parallel.h"
#include "engine/cuda/fiber.h"

namespace haarlight::host_emulation {

constinit thread_local Index3 threadIdx, blockIdx, blockDim;

namespace {

constexpr std::size_t stackBytes = 64 << 10;
/// Blocks that a host thread takes at a time.
constexpr std::size_t blocksAtATime = 32;

/// Runs blocks, one after the other, on one host thread. The fibers of its threads stay for the
/// next block.
class BlockRunner {
 public:
  void run(const std::string& kernel, std::size_t block, Index3 threadsPerBlock,
           const std::function<void()>& thread);

  /// Lets the other threads of the block go on.
  void waitAtBarrier() { leave(running_); }
  bool blockIsFresh() const { return blockIsFresh_; }

 private:
  struct Thread {
    Thread(BlockRunner& runner, std::size_t number)
        : fiber(stackBytes, [&runner, number] { runner.runThread(number); }) {}
    Fiber fiber;
    bool ended = false;
  };

  void runThread(std::size_t number);
  void enter(Fiber& from, std::size_t number);
  void leave(std::size_t number);
  std::size_t runToBarrier();

  Fiber host_;
  std::deque<Thread> threads_;
  std::size_t count_ = 0, running_ = 0;
  const std::function<void()>* thread_ = nullptr;
  bool ascending_ = true, blockIsFresh_ = true;
};

constinit thread_local BlockRunner* runner = nullptr;

void BlockRunner::runThread(std::size_t number) {
  for (;;) {
    (*thread_)();
    threads_[number].ended = true;
    leave(number);
  }
}

void BlockRunner::enter(Fiber& from, std::size_t number) {
  running_ = number;
  const auto n = unsigned(number);
  threadIdx = {n % blockDim.x, n / blockDim.x % blockDim.y, n / (blockDim.x * blockDim.y)};
  from.handOver(threads_[number].fiber);
}

void BlockRunner::leave(std::size_t number) {
  blockIsFresh_ = false;
  Fiber& own = threads_[number].fiber;
  const bool isLast = number == (ascending_ ? count_ - 1 : 0);
  if (isLast)
    own.handOver(host_);
  else
    enter(own, ascending_ ? number + 1 : number - 1);
}

/// Runs every thread until it meets a barrier or ends. Returns how many have ended.
std::size_t BlockRunner::runToBarrier() {
  enter(host_, ascending_ ? 0 : count_ - 1);
  return std::size_t(std::count_if(threads_.begin(), threads_.begin() + std::ptrdiff_t(count_),
                                   [](const Thread& thread) { return thread.ended; }));
}

void BlockRunner::run(const std::string& kernel, std::size_t block, Index3 threadsPerBlock,
                      const std::function<void()>& thread) {
  blockDim = threadsPerBlock;
  blockIdx = {unsigned(block), 0, 0};
  count_ = std::size_t(blockDim.x) * blockDim.y * blockDim.z;
  while (threads_.size() < count_) threads_.emplace_back(*this, threads_.size());
  for (Thread& each : threads_) each.ended = false;
  thread_ = &thread;
  ascending_ = block % 2 == 0;
  blockIsFresh_ = true;
  std::size_t ended = 0;
  while (ended == 0) ended = runToBarrier();
  if (ended < count_)
    throw std::logic_error("kernel " + kernel + ": " + std::to_string(ended) +
                           " threads of block " + std::to_string(block) + " ended while " +
                           std::to_string(count_ - ended) + " waited at a barrier");
}

}  // namespace

void __syncthreads() {
  runner->waitAtBarrier();
}

void newSharedMemory(void* memory, std::size_t bytes) {
  if (runner->blockIsFresh()) std::memset(memory, 0xff, bytes);
}

void runBlocks(const std::string& kernel, std::size_t blocks, Index3 threadsPerBlock,
               const std::function<void()>& thread) {
  parallelFor(blocks, blocksAtATime, [&](std::size_t begin, std::size_t end) {
    // Threads that wait at a barrier cannot be ended: when run() throws, all are thrown away.
    thread_local std::unique_ptr<BlockRunner> ownRunner;
    std::unique_ptr<BlockRunner> current =
        ownRunner ? std::move(ownRunner) : std::make_unique<BlockRunner>();
    runner = current.get();
    for (std::size_t block = begin; block < end; ++block)
      current->run(kernel, block, threadsPerBlock, thread);
    ownRunner = std::move(current);
  });
}

}  // namespace haarlight::host_emulation
