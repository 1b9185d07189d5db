#pragma once

namespace haarlight {

/// While it lives, the first Ctrl-C is remembered instead of ending the program; a second one ends
/// it.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;
};

}  // namespace haarlight
