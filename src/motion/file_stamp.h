#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace haarlight {

/// Tells whether a file is still the one that was opened: its size in bytes and its time of change.
struct FileStamp {
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type changed;

  bool operator==(const FileStamp&) const = default;
};

/// Throws InputError when there is no plain file; `what` names it in the message ("mesh", …).
FileStamp fileStamp(const std::filesystem::path& path, const std::string& what);

/// Throws InputError when the file is no longer the one with this stamp.
void requireUnchanged(const std::filesystem::path& path, const std::string& what,
                      const FileStamp& stamp);

}  // namespace haarlight
