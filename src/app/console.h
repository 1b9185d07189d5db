#pragma once

#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

#include "render/progress.h"

namespace haarlight {

/// What a command says: results on stdout, everything else on stderr.
class Console {
 public:
  /// `json`: results as one JSON object. `quiet`: no messages and no progress, only warnings.
  Console(bool json, bool quiet);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void message(const std::string& line);
  void warning(const std::string& line);

  /// A progress bar on a terminal for tasks that take over a second.
  Progress progress();

  /// Shown after the progress bar, such as how good the result is so far.
  void progressDetail(const std::string& detail);

  /// Prints the results: as they are with --json, else one line per entry, "key: value", with
  /// underscores as blanks and nested entries indented.
  void results(const nlohmann::ordered_json& results);

 private:
  using Clock = std::chrono::steady_clock;

  void showProgress(const std::string& task, double finished);
  void clearProgress();

  bool json_;
  bool quiet_;
  bool terminal_;
  bool colored_;
  std::mutex mutex_;
  std::string task_, detail_;
  Clock::time_point taskStart_;
  Clock::time_point lastShown_;
  bool shown_ = false;
};

/// Whether colours suit what is written to a file descriptor: a terminal, and NO_COLOR is not set.
bool colorsWanted(int descriptor);

/// "haarlight: <kind>: <line>" on stderr; the kind is coloured on a terminal unless NO_COLOR is
/// set.
void printToStderr(const std::string& kind, const std::string& line);

}  // namespace haarlight
