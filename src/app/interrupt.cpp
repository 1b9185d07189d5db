#include "app/interrupt.h"

#include <csignal>

namespace haarlight {

namespace {

volatile std::sig_atomic_t received = 0;

void remember(int) {
  received = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

InterruptWatch::InterruptWatch() {
  received = 0;
  std::signal(SIGINT, remember);
}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, SIG_DFL);
}

bool InterruptWatch::interrupted() const {
  return received != 0;
}

}  // namespace haarlight
