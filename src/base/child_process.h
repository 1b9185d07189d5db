#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file_descriptor.h"

namespace haarlight {

/// The first plain file called `name` that may be executed in the folders of $PATH; empty entries
/// are passed over.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// How a program ended.
struct ChildEnd {
  bool success = false;  ///< it exited with status 0
  /// The end of what it wrote to standard error, at most 1 KiB, as one line with "; " between the
  /// lines; when it wrote nothing, its exit status or signal in words.
  std::string words;
};

/// A program that reads from us. It runs without a shell and in a process group of its own, so that
/// Ctrl-C in a terminal reaches us alone; what it writes to standard output is dropped. When the
/// object goes before finish(), the whole group is killed.
class ChildProcess {
 public:
  /// Throws InputError when the program cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Passes bytes to its standard input and returns when all are passed; false when it does not
  /// read any more (no SIGPIPE is raised).
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);

  /// Closes its standard input and waits for its end; once it has ended, says again how.
  ChildEnd finish();

 private:
  bool waitForReader();
  void keepErrors();
  void waitForEnd();

  pid_t process_ = 0;  ///< 0 when it has ended
  int status_ = 0;     ///< of waitpid, then
  FileDescriptor input_, errors_;
  std::string errorText_;
};

}  // namespace haarlight
