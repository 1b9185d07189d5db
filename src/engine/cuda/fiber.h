#pragma once

#include <setjmp.h>
#include <ucontext.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace haarlight {

/// A thread of execution with a stack of its own that runs only when another one hands over to it
/// (POSIX ucontext, and setjmp where a fiber goes on). All fibers that hand over to each other
/// belong to one host thread.
class Fiber {
 public:
  /// The host thread itself, on the stack it has.
  Fiber() = default;
  /// A fiber that runs `body` when it is first handed to. `body` must never return.
  Fiber(std::size_t stackBytes, std::function<void()> body);
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Stops this fiber, which must be the running one, and lets `next` go on. Returns when another
  /// fiber hands over to this one.
  void handOver(Fiber& next);

 private:
  static void start();
  void leaveFor(Fiber& next);
  void arrive();

  std::function<void()> body_;
  std::unique_ptr<std::byte[]> stack_;
  ucontext_t context_{};  // where it begins
  jmp_buf place_{};       // where it goes on
  bool hasBegun_ = true;  // false until it is first handed to
  /// What AddressSanitizer wants to know of a stack: its bottom, its size and its shadow.
  [[maybe_unused]] const void* stackBottom_ = nullptr;
  [[maybe_unused]] std::size_t stackBytes_ = 0;
  [[maybe_unused]] void* shadowStack_ = nullptr;
};

}  // namespace haarlight
