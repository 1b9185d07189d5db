#include "verify/report/host.h"

#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace haarlight::verify {

namespace {

std::string processorName() {
  std::ifstream information("/proc/cpuinfo");
  for (std::string line; std::getline(information, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

}  // namespace

std::string hostDescription() {
  utsname system{};
  uname(&system);
  return processorName() + ", " + std::to_string(std::thread::hardware_concurrency()) +
         " threads, " + system.sysname + " " + system.release + " " + system.machine;
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace haarlight::verify
