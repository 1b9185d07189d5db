#define DOCTEST_CONFIG_IMPLEMENT
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "test_support.h"

namespace haarlight::test {

namespace fs = std::filesystem;

std::optional<fs::path> testData(const std::string& relativePath) {
  const char* folder = std::getenv("HAARLIGHT_TEST_DATA");
  const fs::path path = fs::path(folder ? folder : HAARLIGHT_TEST_DATA_DEFAULT) / relativePath;
  if (fs::exists(path)) return path;
  std::printf("SKIPPED: test data %s is not there\n", path.c_str());
  return std::nullopt;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "haarlight-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void writeFile(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string readFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace haarlight::test

/// Each test process has its own PoCL cache (several processes sharing one can crash), and all
/// share one table cache apart from the user's.
int main(int argc, char** argv) {
  const haarlight::test::TemporaryFolder poclCache;
  setenv("POCL_CACHE_DIR", poclCache.path().c_str(), 1);
  setenv("HAARLIGHT_CACHE_DIR", HAARLIGHT_TEST_CACHE, 0);
  doctest::Context context(argc, argv);
  return context.run();
}
