#include "engine/cuda/fiber.h"

#include <stdexcept>

#if defined(__SANITIZE_ADDRESS__)  // GCC
#define HAARLIGHT_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)  // Clang
#define HAARLIGHT_ADDRESS_SANITIZER
#endif
#endif

#ifdef HAARLIGHT_ADDRESS_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

namespace haarlight {

namespace {

/// The fiber that hands over, and the one that it hands over to.
constinit thread_local Fiber *leaving = nullptr, *entering = nullptr;

}  // namespace

Fiber::Fiber(std::size_t stackBytes, std::function<void()> body)
    : body_(std::move(body)),
      stack_(std::make_unique_for_overwrite<std::byte[]>(stackBytes)),
      hasBegun_(false),
      stackBottom_(stack_.get()),
      stackBytes_(stackBytes) {
  if (getcontext(&context_) != 0) throw std::runtime_error("getcontext failed");
  context_.uc_stack.ss_sp = stack_.get();
  context_.uc_stack.ss_size = stackBytes;
  makecontext(&context_, start, 0);
}

void Fiber::start() {
  Fiber& self = *entering;
  self.arrive();
  self.body_();
}

#ifdef HAARLIGHT_ADDRESS_SANITIZER
// It knows swapcontext.
void Fiber::leaveFor(Fiber& next) {
  if (swapcontext(&context_, &next.context_) != 0) throw std::runtime_error("swapcontext failed");
}
#else
// swapcontext asks the kernel for the signal mask at every turn, which takes most of the time.
void Fiber::leaveFor(Fiber& next) {
  if (_setjmp(place_) != 0) return;
  if (next.hasBegun_) _longjmp(next.place_, 1);
  next.hasBegun_ = true;
  setcontext(&next.context_);
  throw std::runtime_error("setcontext failed");
}
#endif

void Fiber::handOver(Fiber& next) {
  leaving = this;
  entering = &next;
#ifdef HAARLIGHT_ADDRESS_SANITIZER
  __sanitizer_start_switch_fiber(&shadowStack_, next.stackBottom_, next.stackBytes_);
#endif
  leaveFor(next);
  arrive();
}

void Fiber::arrive() {
#ifdef HAARLIGHT_ADDRESS_SANITIZER
  // Tells besides where the other stack lies, which is not known of the host thread's.
  __sanitizer_finish_switch_fiber(shadowStack_, &leaving->stackBottom_, &leaving->stackBytes_);
#endif
}

}  // namespace haarlight
