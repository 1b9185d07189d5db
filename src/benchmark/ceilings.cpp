#include "benchmark/ceilings.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <new>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "benchmark/vector_loops.h"

namespace haarlight::benchmark {

namespace {

constexpr std::size_t kibibyte = 1024, mebibyte = 1024 * kibibyte;

/// Zeros of a thread's own. They begin at a huge page: a set that lies across such a border may not
/// fit the nearest cache, where that finds its lines by hashed addresses.
class ThreadMemory {
 public:
  ThreadMemory() = default;
  explicit ThreadMemory(std::size_t bytes)
      : blocks_(static_cast<MemoryBlock*>(::operator new(bytes, alignment))) {
    std::uninitialized_value_construct_n(blocks_.get(), bytes / sizeof(MemoryBlock));
  }

  MemoryBlock* data() { return blocks_.get(); }

 private:
  static constexpr std::align_val_t alignment{2 * mebibyte};
  struct Release {
    void operator()(MemoryBlock* blocks) const { ::operator delete(blocks, alignment); }
  };

  std::unique_ptr<MemoryBlock, Release> blocks_;
};

class CeilingMeasurement {
 public:
  CeilingMeasurement(const CeilingPlan& plan, const Progress& progress)
      : plan_(plan), progress_(progress), loops_(usableVectorLoops().back()) {
    std::size_t most = 0;
    for (const MemoryCeiling& level : plan.memory) most = std::max(most, level.bytesPerThread);
    memory_.resize(plan.threads);
    results_.resize(plan.threads);
    parallelFor(plan.threads, 1,
                [&](std::size_t thread, std::size_t) { memory_[thread] = ThreadMemory(most); });
  }

  Ceilings measure() {
    addTasks();
    for (Task& task : tasks_) calibrate(task);
    for (int round = 0; round < plan_.rounds; ++round)
      for (Task& task : tasks_) {
        task.seconds = std::min(task.seconds, secondsOf(task));
        report();
      }
    return result();
  }

 private:
  struct Task {
    /// What a thread, by its number, does so many times.
    std::function<void(std::size_t thread, std::size_t passes)> work;
    std::size_t passes = 1;
    double seconds = 0;
  };

  /// Copying and reading each set of memory, then the operations.
  void addTasks() {
    for (const MemoryCeiling& level : plan_.memory) {
      const std::size_t blocks = level.bytesPerThread / sizeof(MemoryBlock);
      tasks_.push_back({[this, half = blocks / 2](std::size_t thread, std::size_t passes) {
        MemoryBlock* set = memory_[thread].data();
        loops_.copy(set + half, set, half, passes);
      }});
      tasks_.push_back({[this, blocks](std::size_t thread, std::size_t passes) {
        results_[thread] += loops_.read(memory_[thread].data(), blocks, passes);
      }});
    }
    tasks_.push_back({[this](std::size_t thread, std::size_t passes) {
      results_[thread] += loops_.join(std::uint32_t(thread + 1), passes);
    }});
    tasks_.push_back({[this](std::size_t thread, std::size_t passes) {
      results_[thread] += std::uint32_t(loops_.multiplyAdd(0.5f, float(thread + 1), passes));
    }});
  }

  double secondsOf(const Task& task) const {
    const Stopwatch watch;
    parallelFor(plan_.threads, 1,
                [&](std::size_t thread, std::size_t) { task.work(thread, task.passes); });
    return watch.total();
  }

  void calibrate(Task& task) {
    task.seconds = secondsOf(task);
    while (task.seconds < plan_.seconds) {
      task.passes *= 2;
      task.seconds = secondsOf(task);
    }
    report();
  }

  void report() {
    const double steps = double(tasks_.size()) * double(1 + plan_.rounds);
    if (progress_) progress_("measuring ceilings", double(++reported_) / steps);
  }

  /// Of all threads together.
  static double perSecond(const Task& task, double threads) {
    return threads * double(task.passes) / task.seconds;
  }

  Ceilings result() const {
    Ceilings ceilings{plan_.threads, loops_.instructions, plan_.memory, 0, 0};
    auto task = tasks_.begin();
    for (MemoryCeiling& level : ceilings.memory) {
      level.copy = double(level.bytesPerThread) * perSecond(*task++, plan_.threads);
      level.read = double(level.bytesPerThread) * perSecond(*task++, plan_.threads);
    }
    ceilings.joins = loops_.joinsPerPass * perSecond(*task++, plan_.threads);
    ceilings.multiplyAdds = 2 * loops_.multiplyAddsPerPass * perSecond(*task, plan_.threads);
    return ceilings;
  }

  const CeilingPlan& plan_;
  const Progress& progress_;
  VectorLoops loops_;
  std::vector<ThreadMemory> memory_;
  /// Of what was computed, so that it has to be.
  std::vector<std::uint32_t> results_;
  std::vector<Task> tasks_;
  std::size_t reported_ = 0;
};

}  // namespace

CeilingPlan ceilingPlan(unsigned threads) {
  const std::size_t most = std::max(16 * mebibyte, 256 * mebibyte / threads / mebibyte * mebibyte);
  CeilingPlan plan{.threads = threads, .memory = {}};
  const auto add = [&](const char* name, std::size_t bytes, double holds) {
    plan.memory.push_back({name, bytes, holds, 0, 0});
  };
  const auto twice = [](std::size_t bytes) { return 2 * double(bytes); };
  add("L1", 16 * kibibyte, twice(16 * kibibyte));
  add("L2", 512 * kibibyte, twice(512 * kibibyte));
  add("L3", 4 * mebibyte, twice(4 * mebibyte) * threads);
  add("RAM", most, std::numeric_limits<double>::infinity());
  return plan;
}

Ceilings measureCeilings(const CeilingPlan& plan, const Progress& progress) {
  return CeilingMeasurement(plan, progress).measure();
}

}  // namespace haarlight::benchmark
