#include "engine/device_selection.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "base/error.h"

namespace haarlight {

namespace {

using Choices = std::vector<DeviceChoice>;

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool isNumber(const std::string& text) {
  return !text.empty() && text.size() < 9 &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

template <typename Predicate>
std::optional<std::size_t> findDevice(const Choices& devices, const Predicate& matches) {
  const auto found = std::ranges::find_if(devices, matches);
  if (found == devices.end()) return std::nullopt;
  return std::size_t(found - devices.begin());
}

std::optional<std::size_t> firstUsable(const Choices& devices) {
  const auto gpu = findDevice(
      devices, [](const DeviceChoice& device) { return !device.isCpu && device.problem.empty(); });
  if (gpu) return gpu;
  return findDevice(devices, [](const DeviceChoice& device) { return device.problem.empty(); });
}

std::optional<std::size_t> named(const Choices& devices, const std::string& selector) {
  if (isNumber(selector)) {
    const std::size_t index = std::stoul(selector);
    return index < devices.size() ? std::optional(index) : std::nullopt;
  }
  const std::string part = lowerCase(selector);
  return findDevice(devices, [&](const DeviceChoice& device) {
    return lowerCase(device.name).find(part) != std::string::npos;
  });
}

}  // namespace

std::size_t chooseDevice(const std::string& api, const std::vector<DeviceChoice>& devices,
                         const std::string& selector) {
  const auto chosen = selector.empty() ? firstUsable(devices) : named(devices, selector);
  if (!chosen && selector.empty())
    throw InputError("no " + api + " device can be used; `haarlight devices` says why");
  if (!chosen)
    throw InputError("no " + api + " device is called or numbered '" + selector +
                     "'; `haarlight devices` lists them");
  const DeviceChoice& device = devices[*chosen];
  if (!device.problem.empty())
    throw InputError(api + " device " + device.name + " cannot be used: " + device.problem);
  return *chosen;
}

}  // namespace haarlight
