#include "motion/file_stamp.h"

#include "base/error.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannotRead(const fs::path& path, const std::string& what,
                             const std::string& problem) {
  throw InputError("cannot read " + what + " " + path.string() + ": " + problem);
}

}  // namespace

FileStamp fileStamp(const fs::path& path, const std::string& what) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) cannotRead(path, what, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status))
    cannotRead(path, what, "it is no plain file");
  FileStamp stamp;
  stamp.bytes = fs::file_size(path, error);
  if (!error) stamp.changed = fs::last_write_time(path, error);
  if (error) cannotRead(path, what, error.message());
  return stamp;
}

void requireUnchanged(const fs::path& path, const std::string& what, const FileStamp& stamp) {
  const FileStamp now = fileStamp(path, what);
  if (now.bytes != stamp.bytes)
    cannotRead(path, what,
               "it held " + std::to_string(stamp.bytes) +
                   " bytes when it was opened and now holds " + std::to_string(now.bytes));
  if (now != stamp) cannotRead(path, what, "it was written to after it had been opened");
}

}  // namespace haarlight
