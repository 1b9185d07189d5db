#include <filesystem>
#include <string>

#include "embedded/embedding_samples.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::string sourceFile(const std::string& name) {
  return readFile(std::filesystem::path(HAARLIGHT_SOURCE_FOLDER) / "tests/scene/embedded" / name);
}

}  // namespace

TEST_CASE("an embedded text has the bytes of its file, and a zero behind them") {
  const std::string_view text = embedded::embedding_samples("odd.txt");
  CHECK(text.find('\xFF') != std::string_view::npos);
  CHECK(text == sourceFile("odd.txt"));
  CHECK(text.data()[text.size()] == '\0');
}

TEST_CASE("an embedded kernel begins with a line that names it") {
  CHECK(embedded::embedding_samples("sample.cl") ==
        "#line 1 \"sample.cl\"\n" + sourceFile("sample.cl"));
}

TEST_CASE("an empty embedded text differs from an unknown one") {
  CHECK(embedded::embedding_samples("empty.txt").empty());
  CHECK(embedded::embedding_samples("empty.txt").data() != nullptr);
  CHECK(embedded::embedding_samples("unknown.txt").data() == nullptr);
}
