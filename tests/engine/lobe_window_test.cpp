#include "engine/lobe_window.h"

#include <doctest/doctest.h>

#include <random>
#include <set>

using namespace haarlight;

TEST_CASE("lobe window: slots that stay keep their places, others make room") {
  LobeWindow window(3);
  const std::vector<std::uint32_t> first{2, 5, 9}, second{5, 7, 9}, third{7};
  CHECK(window.open(first).places == std::vector<std::uint32_t>{0, 1, 2});
  const auto change = window.open(second);
  CHECK(change.slots == std::vector<std::uint32_t>{7});
  CHECK(change.places == std::vector<std::uint32_t>{0});
  CHECK(window.placeOf(5) == 1);
  CHECK(window.placeOf(9) == 2);
  CHECK(window.open(third).slots.empty());
  CHECK(window.open({}).slots.empty());
}

TEST_CASE("lobe window: whatever is asked, every wanted slot has a place of its own") {
  std::mt19937 random(1);
  LobeWindow window(20);
  for (int batch = 0; batch < 500; ++batch) {
    std::set<std::uint32_t> wanted;
    const std::size_t count = random() % 21;
    while (wanted.size() < count) wanted.insert(random() % 60);
    const std::vector<std::uint32_t> slots(wanted.begin(), wanted.end());
    const auto change = window.open(slots);
    for (const std::uint32_t slot : change.slots) REQUIRE(wanted.contains(slot));
    REQUIRE(window.slots().size() <= 20);
    std::set<std::uint32_t> places;
    for (const std::uint32_t slot : slots) {
      REQUIRE(window.slots()[window.placeOf(slot)] == slot);
      places.insert(window.placeOf(slot));
    }
    REQUIRE(places.size() == slots.size());
  }
}
