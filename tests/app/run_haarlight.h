#pragma once

/// Runs the program as a user does, in a process of its own.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace haarlight::test {

using Arguments = std::vector<std::string>;

/// How the program ended and what it said.
struct Outcome {
  int exitCode = -1;  ///< −1 when a signal ended it
  int signal = 0;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

struct Surroundings {
  std::map<std::string, std::string> environment;  ///< added to the test's own
  std::filesystem::path standardOutput;            ///< where output goes instead of the outcome
  bool terminal = false;                           ///< standard error is a terminal
  std::optional<std::uint64_t> fileSizeLimit;      ///< writing fails beyond this many bytes
  /// Ctrl-C (SIGINT) is sent once this file is there.
  std::filesystem::path interruptAfter;
};

Outcome runHaarlight(const Arguments& arguments, const Surroundings& surroundings = {});

/// Runs with --json, checks that it succeeds, and parses what it prints.
nlohmann::json resultsOf(Arguments arguments, const Surroundings& surroundings = {});

/// Checks that the program refuses: exit code 2, nothing on standard output, and one line on
/// standard error that starts with "haarlight: error:" and contains `named`.
void checkRefused(const Arguments& arguments, const std::string& named,
                  const Surroundings& surroundings = {});

/// The same of several lists.
Arguments joined(Arguments first, const Arguments& second);

bool contains(const std::string& text, const std::string& part);

/// Whether `Surroundings::terminal` can be had; else a line "SKIPPED: …" has been printed.
bool haveTerminals();

/// Whether an OpenCL device can be used; else a line "SKIPPED: …" has been printed.
bool haveOpenCl();

}  // namespace haarlight::test
