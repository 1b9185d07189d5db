#pragma once

#include <stdexcept>
#include <string>

namespace haarlight {

/// What the user gave cannot be used: a file, an option, a scene. The message is one line that says
/// what is wrong, where, and what to do; the command line prints it and exits with code 2. Every
/// other exception means that the program failed (exit code 1).
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace haarlight
