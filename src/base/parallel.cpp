#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace haarlight {

namespace {
std::atomic<unsigned> requestedThreads{0};
}

void setThreadCount(unsigned count) {
  requestedThreads = count;
}

unsigned threadCount() {
  const unsigned requested = requestedThreads;
  return requested ? requested : std::max(1u, std::thread::hardware_concurrency());
}

void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& body) {
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t rangeCount = (count + grain - 1) / grain;
  std::atomic<std::size_t> nextRange{0};
  std::exception_ptr failure;
  std::mutex failureMutex;

  const auto work = [&] {
    for (std::size_t range = nextRange++; range < rangeCount; range = nextRange++) {
      try {
        body(range * grain, std::min(count, (range + 1) * grain));
      } catch (...) {
        const std::lock_guard lock(failureMutex);
        if (!failure) failure = std::current_exception();
        nextRange = rangeCount;
      }
    }
  };

  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < std::min<std::size_t>(threadCount(), rangeCount); ++i)
    helpers.emplace_back(work);
  work();
  for (auto& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace haarlight
