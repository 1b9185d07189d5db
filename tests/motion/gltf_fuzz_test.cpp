#include <random>

#include "base/error.h"
#include "gltf_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Loads and poses a damaged file, or sees it refused; anything else ends the test. Says which.
bool survives(const TemporaryFolder& folder, const std::string& content) {
  // A fresh file: some file systems wait for the disk when one is overwritten.
  std::filesystem::remove(folder / "damaged");
  writeFile(folder / "damaged", content);
  try {
    const AnimatedMesh loaded = loadGltf(folder / "damaged", "");
    if (!loaded.motion) return true;
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const auto positions = loaded.motion->positions(part * loaded.motion->duration());
      CHECK(positions.size() == loaded.mesh.mesh.positions.size());
    }
    return true;
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return false;
  }
}

void checkTruncations(const std::string& whole) {
  const TemporaryFolder folder;
  REQUIRE(survives(folder, whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(survives(folder, whole.substr(0, size)));
  }
}

/// One to four bytes anywhere become others.
void checkRandomChanges(const std::string& whole, unsigned seed) {
  const TemporaryFolder folder;
  std::mt19937 random(seed);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole;
    for (unsigned change = 0; change <= random() % 4; ++change)
      damaged[random() % damaged.size()] = char(random());
    CAPTURE(i);
    refused += !survives(folder, damaged);
  }
  // Most changes hit a name, a brace or an index; some only a coordinate.
  CHECK(refused > 300);
  CHECK(refused < 3000);
}

/// The digits of one number in the JSON become others: sizes, offsets, indices.
void checkRandomNumbers(const GltfBuilder& builder, unsigned seed) {
  const TemporaryFolder folder;
  std::mt19937 random(seed);
  const std::string json = builder.json("");
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = json;
    std::size_t at = random() % damaged.size();
    at = damaged.find_first_of("0123456789", at);
    if (at == std::string::npos) continue;
    constexpr const char* others[]{"-1",         "0",          "3",
                                   "17",         "255",        "65536",
                                   "2147483647", "4294967295", "9223372036854775807",
                                   "1e30",       "\"x\"",      "[]"};
    damaged.replace(at, 1, others[random() % std::size(others)]);
    CAPTURE(damaged);
    survives(folder, glbOf(damaged, builder.bytes));
  }
}

}  // namespace

TEST_CASE("a glTF file cut off anywhere is refused") {
  checkTruncations(everyFeature().gltf());
}

TEST_CASE("a GLB cut off anywhere is refused") {
  checkTruncations(everyFeature().glb());
}

TEST_CASE("a glTF file with changed bytes is read or refused") {
  checkRandomChanges(everyFeature().gltf(), 1);
}

TEST_CASE("a GLB with changed bytes is read or refused") {
  checkRandomChanges(everyFeature().glb(), 2);
}

TEST_CASE("a glTF file with changed numbers is read or refused") {
  checkRandomNumbers(everyFeature(), 3);
}
