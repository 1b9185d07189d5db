#include "visibility/sphere_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "base/file.h"
#include "base/parallel.h"
#include "test_support.h"
#include "visibility/exact_visibility.h"

using namespace haarlight;

namespace {

const SphereTable& sharedTable() {
  static const SphereTable table = SphereTable::load(cacheFolder());
  return table;
}

bool sameWords(const SphereTable& a, const SphereTable& b) {
  return std::ranges::equal(a.entries(), b.entries()) && std::ranges::equal(a.groups(), b.groups());
}

}  // namespace

TEST_CASE("an entry is the exact mask of its bin's direction and radius") {
  std::mt19937 random(1);
  int bits = 0, different = 0;
  for (int i = 0; i < 300; ++i) {
    const int direction = int(random() % texelCount), bin = int(random() % radiusBins);
    const glm::vec3 v(texelDirection(direction));
    const Sphere sphere{v, float(std::sqrt(radiusBinCenter(bin)))};
    BitCube exact;
    addSphereExactly(exact, sphere, {0, 0, 0}, v);
    const auto mask = sharedTable().mask(direction * radiusBins + bin);
    for (int row = 0; row < bitCubeRows; ++row) {
      bits += std::popcount(exact.rows[row]);
      different += std::popcount(exact.rows[row] ^ mask.rows[row]);
    }
  }
  // The table compares in float32: only texels whose centre lies on the cap's rim may differ.
  CHECK(different <= bits / 2000);
}

TEST_CASE("groups that are kept are those with a set bit, one entry after the other") {
  const SphereTable& table = sharedTable();
  std::size_t place = 1;  // after the empty group
  for (int entry = 0; entry < sphereTableEntries; ++entry) {
    const std::uint32_t occupied = table.entries()[entry] % (1u << SphereTable::groupCount);
    REQUIRE((table.entries()[entry] >> SphereTable::groupCount) == place);
    for (int i = 0; i < std::popcount(occupied); ++i, ++place) {
      const auto rows =
          table.groups().subspan(place * SphereTable::groupRows, SphereTable::groupRows);
      REQUIRE(std::ranges::any_of(rows, [](std::uint32_t row) { return row != 0; }));
    }
    if (entry % 97) continue;
    const BitCube mask = table.mask(entry);
    for (int row = 0; row < bitCubeRows; ++row)
      REQUIRE((mask.rows[row] == 0 || (occupied >> row / SphereTable::groupRows & 1)));
  }
  CHECK(table.groups().size() == place * SphereTable::groupRows);
}

TEST_CASE("the table does not depend on the number of threads") {
  setThreadCount(1);
  const SphereTable single = SphereTable::build();
  setThreadCount(5);
  const SphereTable several = SphereTable::build();
  setThreadCount(0);
  CHECK(sameWords(single, several));
}

TEST_CASE("a damaged or cut cache file is built again") {
  const test::TemporaryFolder folder;
  const auto file = sphereTableFile(folder.path());
  const SphereTable built = SphereTable::load(folder.path());
  REQUIRE(std::filesystem::exists(file));
  const auto size = std::filesystem::file_size(file);
  CHECK(size == built.entries().size_bytes() + built.groups().size_bytes() + 8);

  SUBCASE("one bit changed") {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(12345678);
    stream.put(char(0x5a));
  }
  SUBCASE("cut short") {
    std::filesystem::resize_file(file, 1000);
  }
  SUBCASE("longer") {
    std::filesystem::resize_file(file, size + 1);
  }
  const SphereTable again = SphereTable::load(folder.path());
  CHECK(sameWords(built, again));
  CHECK(sameWords(built, SphereTable::load(folder.path())));
  CHECK(std::filesystem::file_size(file) == size);
}

TEST_CASE("an unwritable cache folder only costs time") {
  CHECK(sameWords(SphereTable::load("/proc/no/such/folder"), sharedTable()));
}
