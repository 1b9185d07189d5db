#pragma once

/// What every test may use: where the real data lies, how to skip, a place for files.

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <string>

namespace haarlight::test {

/// Path of a file below the test data folder (environment variable HAARLIGHT_TEST_DATA, or the
/// folder given to CMake), or nothing when it is not there; then a line "SKIPPED: …" has been
/// printed and the test should return.
std::optional<std::filesystem::path> testData(const std::string& relativePath);

/// A fresh empty folder, removed when the object goes.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes `bytes` to `path`.
void writeFile(const std::filesystem::path& path, const std::string& bytes);

/// The whole content of `path`.
std::string readFile(const std::filesystem::path& path);

}  // namespace haarlight::test
