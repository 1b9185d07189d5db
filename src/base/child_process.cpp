#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <system_error>

#include "base/error.h"
#include "base/text_format.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t keptErrorBytes = 1024;

struct Pipe {
  FileDescriptor reading, writing;
};

Pipe makePipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

/// What happens in the child before the program starts.
class SpawnSettings {
 public:
  SpawnSettings(const Pipe& input, const Pipe& errors) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, input.reading.number(), STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files_, errors.writing.number(), STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  pid_t spawn(const fs::path& program, const std::vector<std::string>& arguments) const {
    std::vector<char*> pointers{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
      pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    pid_t process = 0;
    const int error =
        posix_spawn(&process, program.c_str(), &files_, &attributes_, pointers.data(), environ);
    if (error != 0)
      throw InputError("cannot start " + program.string() + ": " + std::strerror(error));
    return process;
  }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

/// While it lives, a broken pipe does not end the program; the rest of the program keeps its own
/// way of dealing with SIGPIPE.
class BrokenPipeGuard {
 public:
  BrokenPipeGuard() {
    sigemptyset(&pipeSignal_);
    sigaddset(&pipeSignal_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipeSignal_, &before_);
  }
  ~BrokenPipeGuard() {
    sigset_t pending;
    int taken;
    sigpending(&pending);
    if (sigismember(&pending, SIGPIPE) && !sigismember(&before_, SIGPIPE))
      sigwait(&pipeSignal_, &taken);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  BrokenPipeGuard(const BrokenPipeGuard&) = delete;
  BrokenPipeGuard& operator=(const BrokenPipeGuard&) = delete;

 private:
  sigset_t pipeSignal_, before_;
};

std::string oneLine(const std::string& text) {
  std::istringstream lines(text);
  std::string result, line;
  while (std::getline(lines, line)) {
    line.erase(0, line.find_first_not_of(" \t"));
    result = joined({result, visible(line)}, "; ");
  }
  return result;
}

std::string statusText(int status) {
  return WIFSIGNALED(status) ? "it was ended by signal " + std::to_string(WTERMSIG(status))
                             : "it ended with exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

std::optional<fs::path> findProgram(const std::string& name) {
  const char* variable = std::getenv("PATH");
  std::istringstream folders(variable ? variable : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / name;
    std::error_code ignored;
    if (!folder.empty() && fs::is_regular_file(candidate, ignored) &&
        access(candidate.c_str(), X_OK) == 0)
      return candidate;
  }
  return std::nullopt;
}

ChildProcess::ChildProcess(const fs::path& program, const std::vector<std::string>& arguments) {
  Pipe input = makePipe(), errors = makePipe();
  for (const FileDescriptor* own : {&input.writing, &errors.reading})
    fcntl(own->number(), F_SETFL, O_NONBLOCK);
  process_ = SpawnSettings(input, errors).spawn(program, arguments);
  input_ = std::move(input.writing);
  errors_ = std::move(errors.reading);
}

ChildProcess::~ChildProcess() {
  if (process_ == 0) return;
  killpg(process_, SIGKILL);
  waitForEnd();
}

bool ChildProcess::write(std::span<const std::uint8_t> bytes) {
  if (process_ == 0) return false;
  const BrokenPipeGuard guard;
  while (!bytes.empty()) {
    if (!waitForReader()) continue;
    const ssize_t count = ::write(input_.number(), bytes.data(), bytes.size());
    if (count >= 0)
      bytes = bytes.subspan(std::size_t(count));
    else if (errno != EAGAIN && errno != EINTR)
      return false;
  }
  return true;
}

ChildEnd ChildProcess::finish() {
  input_.close();
  while (errors_.isOpen()) waitForReader();
  if (process_ != 0) waitForEnd();
  const std::string words = oneLine(errorText_);
  return {WIFEXITED(status_) && WEXITSTATUS(status_) == 0,
          words.empty() ? statusText(status_) : words};
}

/// Waits until the program can take input or has written errors, which are kept; true for the
/// former. Its errors must be read all the time, as it waits while nobody reads them.
bool ChildProcess::waitForReader() {
  // Closed descriptors are negative and therefore passed over.
  pollfd states[]{{input_.number(), POLLOUT, 0}, {errors_.number(), POLLIN, 0}};
  if (poll(states, std::size(states), -1) < 0) return false;
  if (states[1].revents != 0) keepErrors();
  return states[0].revents != 0;
}

void ChildProcess::keepErrors() {
  char block[4096];
  const ssize_t count = read(errors_.number(), block, sizeof block);
  if (count == 0) errors_.close();
  if (count <= 0) return;
  errorText_.append(block, std::size_t(count));
  if (errorText_.size() > keptErrorBytes) errorText_.erase(0, errorText_.size() - keptErrorBytes);
}

void ChildProcess::waitForEnd() {
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
}

}  // namespace haarlight
