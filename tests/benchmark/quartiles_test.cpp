#include "benchmark/quartiles.h"

#include <doctest/doctest.h>

#include "base/frame_timing.h"

using namespace haarlight;
using namespace haarlight::benchmark;

TEST_CASE("quartiles are the times at a quarter, half and three quarters") {
  const Quartiles five = quartilesOf({5, 1, 4, 2, 3});
  CHECK(five.count == 5);
  CHECK(five.minimum == 1);
  CHECK(five.lower == 2);
  CHECK(five.median == 3);
  CHECK(five.upper == 4);
  const Quartiles eight = quartilesOf({80, 70, 60, 50, 40, 30, 20, 10});
  CHECK(eight.minimum == 10);
  CHECK(eight.lower == 30);
  CHECK(eight.median == 50);
  CHECK(eight.upper == 70);
}

TEST_CASE("one time is all of its quartiles") {
  const Quartiles one = quartilesOf({0.25});
  CHECK(one.minimum == 0.25);
  CHECK(one.lower == 0.25);
  CHECK(one.median == 0.25);
  CHECK(one.upper == 0.25);
  CHECK(one.perSecond() == 4);
}

TEST_CASE("the median is that of the other measurements") {
  std::vector<double> times;
  for (int count = 1; count <= 12; ++count) {
    times.push_back((count * 7) % 13);
    CHECK(quartilesOf(times).median == median(times));
  }
}
