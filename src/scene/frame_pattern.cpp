#include "scene/frame_pattern.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "base/error.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

/// What a percent sign starts.
struct Placeholder {
  std::size_t length;
  std::optional<int> numberWidth;  ///< nothing for "%%"
};

/// The placeholder at the start of `text`, if it is one.
std::optional<Placeholder> placeholderAt(std::string_view text) {
  if (text.starts_with("%%")) return Placeholder{2, std::nullopt};
  if (text.starts_with("%d")) return Placeholder{2, 1};
  if (text.starts_with("%0") && text.size() > 3 && text[2] >= '1' && text[2] <= '9' &&
      text[3] == 'd')
    return Placeholder{4, text[2] - '0'};
  return std::nullopt;
}

}  // namespace

bool FramePattern::isPattern(const std::string& text) {
  return text.find('%') != std::string::npos;
}

FramePattern::FramePattern(const std::string& text) {
  constexpr std::string_view rule =
      "write one %d or %04d, as in frame_%04d.png, and %% for a percent sign";
  for (std::size_t at = 0; at < text.size();) {
    std::string& part = width_ == 0 ? before_ : after_;
    if (text[at] != '%') {
      part += text[at++];
      continue;
    }
    const auto placeholder = placeholderAt(std::string_view(text).substr(at));
    if (!placeholder)
      throw InputError(fmt::format("cannot use the name {}: '{}' is no number of a frame; {}", text,
                                   text.substr(at, 4), rule));
    if (!placeholder->numberWidth)
      part += '%';
    else if (width_ == 0)
      width_ = *placeholder->numberWidth;
    else
      throw InputError(
          fmt::format("cannot use the name {}: it has two numbers of a frame; {}", text, rule));
    at += placeholder->length;
  }
  if (width_ == 0)
    throw InputError(
        fmt::format("cannot use the name {}: it has no number of a frame; {}", text, rule));
}

fs::path FramePattern::path(int frame) const {
  return fmt::format("{}{:0{}}{}", before_, frame, width_, after_);
}

}  // namespace haarlight
