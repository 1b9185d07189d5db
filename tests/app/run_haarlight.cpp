#include "run_haarlight.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "test_support.h"

namespace haarlight::test {

namespace {

constexpr unsigned secondsAllowed = 120;

/// Both ends of a pseudo-terminal.
struct Terminal {
  int controller = -1;
  int terminal = -1;
  bool opened = false;

  Terminal() {
    opened = openpty(&controller, &terminal, nullptr, nullptr, nullptr) == 0;
    if (opened) fcntl(controller, F_SETFL, O_NONBLOCK);
  }
  ~Terminal() {
    if (!opened) return;
    close(controller);
    close(terminal);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  std::string text() const {
    std::string text;
    char block[4096];
    for (ssize_t count; (count = read(controller, block, sizeof block)) > 0;)
      text.append(block, std::size_t(count));
    return text;
  }
};

void redirect(int descriptor, const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(127);
}

void limitFileSize(std::uint64_t bytes) {
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_IGN);  // so that writing reports an error instead
}

/// Sends SIGINT once the file is there, or not at all when the process ends before.
void interruptWhenThere(pid_t child, const std::filesystem::path& file) {
  siginfo_t ended{};
  while (!std::filesystem::exists(file)) {
    const timespec pause{0, 1000000};
    nanosleep(&pause, nullptr);
    if (waitid(P_PID, id_t(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid)
      return;
  }
  kill(child, SIGINT);
}

[[noreturn]] void replaceProcess(const Arguments& arguments) {
  std::string program = HAARLIGHT_PROGRAM;
  std::vector<char*> pointers{program.data()};
  Arguments copies = arguments;
  for (std::string& argument : copies) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  alarm(secondsAllowed);
  execv(program.c_str(), pointers.data());
  _exit(127);
}

}  // namespace

Outcome runHaarlight(const Arguments& arguments, const Surroundings& surroundings) {
  const TemporaryFolder folder;
  const auto output =
      surroundings.standardOutput.empty() ? folder / "output" : surroundings.standardOutput;
  std::optional<Terminal> terminal;
  if (surroundings.terminal) terminal.emplace();
  const pid_t child = fork();
  if (child == 0) {
    redirect(STDOUT_FILENO, output);
    redirect(STDERR_FILENO, folder / "errors");
    if (terminal) dup2(terminal->terminal, STDERR_FILENO);
    for (const auto& [name, value] : surroundings.environment)
      setenv(name.c_str(), value.c_str(), 1);
    if (surroundings.fileSizeLimit) limitFileSize(*surroundings.fileSizeLimit);
    replaceProcess(arguments);
  }
  if (child > 0 && !surroundings.interruptAfter.empty())
    interruptWhenThere(child, surroundings.interruptAfter);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
    throw std::runtime_error("cannot start " HAARLIGHT_PROGRAM);
  Outcome outcome;
  if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  if (surroundings.standardOutput.empty()) outcome.output = readFile(output);
  outcome.errors = terminal ? terminal->text() : readFile(folder / "errors");
  return outcome;
}

nlohmann::json resultsOf(Arguments arguments, const Surroundings& surroundings) {
  arguments.push_back("--json");
  const Outcome outcome = runHaarlight(arguments, surroundings);
  CAPTURE(arguments);
  CAPTURE(outcome.errors);
  REQUIRE(outcome.exitCode == 0);
  const auto results = nlohmann::json::parse(outcome.output, nullptr, false);
  REQUIRE(results.is_object());
  return results;
}

void checkRefused(const Arguments& arguments, const std::string& named,
                  const Surroundings& surroundings) {
  const Outcome outcome = runHaarlight(arguments, surroundings);
  CAPTURE(arguments);
  CAPTURE(outcome.errors);
  CHECK(outcome.exitCode == 2);
  CHECK(outcome.signal == 0);
  CHECK(outcome.output == "");
  CHECK(outcome.errors.starts_with("haarlight: error: "));
  CHECK(std::ranges::count(outcome.errors, '\n') == 1);
  CHECK(contains(outcome.errors, named));
}

Arguments joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool haveTerminals() {
  if (Terminal().opened) return true;
  std::printf("SKIPPED: no pseudo-terminal can be opened here\n");
  return false;
}

bool haveOpenCl() {
  const auto results = resultsOf({"devices"});
  for (const auto& device : results.at("device"))
    if (device.at("engine") == "opencl" && device.at("usable") == true) return true;
  std::printf("SKIPPED: no OpenCL device can be used\n");
  return false;
}

}  // namespace haarlight::test
