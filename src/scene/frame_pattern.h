#pragma once

#include <filesystem>
#include <string>

namespace haarlight {

/// A file name with a place for the frame's number, such as "frame_%04d.png": "%d" for the number
/// as it is, "%04d" for one with zeros in front, to 4 (1 … 9) characters, "%%" for a percent sign.
class FramePattern {
 public:
  /// Whether the text has a percent sign and is therefore to be read as a pattern.
  static bool isPattern(const std::string& text);

  /// Throws InputError unless the text has exactly one place for the number and no other percent
  /// sign than "%%".
  explicit FramePattern(const std::string& text);

  /// The same name as printf gives.
  std::filesystem::path path(int frame) const;

 private:
  std::string before_, after_;
  int width_ = 0;
};

}  // namespace haarlight
