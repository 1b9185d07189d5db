#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/frame_pattern.h"

namespace haarlight {

/// The files of a folder whose names fit a FramePattern (scene/frame_pattern.h): for "walk_%d.obj"
/// walk_7.obj, walk_12.obj, …; for "walk_%04d.obj" walk_0007.obj, walk_0012.obj, ….
class NumberedFiles {
 public:
  /// The pattern is the file's name; '%' in the names of folders is just that. Throws InputError
  /// when the name is no pattern.
  explicit NumberedFiles(const std::filesystem::path& pattern);

  /// All files of the folder that fit, in order of their numbers, which follow each other. Throws
  /// InputError when there is none, and with the first that is missing in between.
  std::vector<std::filesystem::path> list() const;

 private:
  std::filesystem::path path(int number) const;
  std::optional<int> numberOf(const std::string& name) const;
  std::vector<int> numbersInFolder() const;

  std::filesystem::path folder_;  ///< empty: the current one
  FramePattern name_;
};

}  // namespace haarlight
