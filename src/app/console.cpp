#include "app/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace haarlight {

namespace {

bool stderrIsTerminal() {
  return isatty(STDERR_FILENO) != 0;
}

std::string valueText(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  return value.dump();
}

void appendLines(std::string& text, const nlohmann::ordered_json& results, int indent) {
  const auto append = std::back_inserter(text);
  for (const auto& [key, value] : results.items()) {
    std::string name = key;
    for (char& c : name)
      if (c == '_') c = ' ';
    if (value.is_object()) {
      fmt::format_to(append, "{:{}}{}:\n", "", indent, name);
      appendLines(text, value, indent + 2);
    } else if (value.is_array() && !value.empty() && value.front().is_object()) {
      for (const auto& entry : value) {
        fmt::format_to(append, "{:{}}{}:\n", "", indent, name);
        appendLines(text, entry, indent + 2);
      }
    } else {
      fmt::format_to(append, "{:{}}{}: {}\n", "", indent, name, valueText(value));
    }
  }
}

}  // namespace

bool colorsWanted(int descriptor) {
  const char* noColor = std::getenv("NO_COLOR");
  return isatty(descriptor) != 0 && !(noColor && *noColor);
}

void printToStderr(const std::string& kind, const std::string& line) {
  const bool color = colorsWanted(STDERR_FILENO);
  fmt::print(stderr, "haarlight: {}{}{}: {}\n", color ? "\x1b[1;33m" : "", kind,
             color ? "\x1b[0m" : "", line);
}

Console::Console(bool json, bool quiet)
    : json_(json),
      quiet_(quiet),
      terminal_(stderrIsTerminal()),
      colored_(colorsWanted(STDERR_FILENO)) {}

Console::~Console() {
  clearProgress();
}

void Console::message(const std::string& line) {
  if (quiet_) return;
  clearProgress();
  fmt::print(stderr, "{}\n", line);
}

void Console::warning(const std::string& line) {
  clearProgress();
  printToStderr("warning", line);
}

Progress Console::progress() {
  if (quiet_ || !terminal_) return {};
  return [this](const std::string& task, double finished) { showProgress(task, finished); };
}

void Console::showProgress(const std::string& task, double finished) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (task != task_) {
    task_ = task;
    detail_.clear();
    taskStart_ = lastShown_ = now;
  }
  const double elapsed = std::chrono::duration<double>(now - taskStart_).count();
  if (elapsed < 1 || now - lastShown_ < std::chrono::milliseconds(100)) return;
  lastShown_ = now;
  shown_ = true;
  constexpr int width = 30;
  const int filled = int(std::lround(width * finished));
  const double left = finished > 0 ? elapsed * (1 - finished) / finished : 0;
  fmt::print(stderr, "\r\x1b[K{} [{}{:#<{}}{}{:.<{}}] {:3.0f} %, {:.0f} s left{}", task,
             colored_ ? "\x1b[32m" : "", "", filled, colored_ ? "\x1b[0m" : "", "", width - filled,
             100 * finished, left, detail_);
  std::fflush(stderr);
}

void Console::progressDetail(const std::string& detail) {
  const std::lock_guard lock(mutex_);
  detail_ = ", " + detail;
}

void Console::clearProgress() {
  const std::lock_guard lock(mutex_);
  if (!shown_) return;
  fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
  task_.clear();
}

void Console::results(const nlohmann::ordered_json& results) {
  clearProgress();
  std::string text;
  if (json_)
    text = results.dump(2) + "\n";
  else
    appendLines(text, results, 0);
  std::fwrite(text.data(), 1, text.size(), stdout);  // main looks for errors on the stream
}

}  // namespace haarlight
