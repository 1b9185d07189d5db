#include "hard_shadow/level_of_detail.h"

#include <doctest/doctest.h>

#include <limits>

#include "base/error.h"

using namespace haarlight;

TEST_CASE("a largest edge gives every receiver the depth at which its cells are that small") {
  const AxisBox large{{-4, 0, -4}, {4, 0, 4}}, small{{0, 0, 0}, {0.5, 0.25, 0.1}};
  CHECK(depthsFor({0.1, 0}, large).boundary == 7);   // 8/128 = 0.0625
  CHECK(depthsFor({0.1, 0}, small).boundary == 3);   // 0.5/8 = 0.0625
  CHECK(depthsFor({0.02, 0}, large).boundary == 9);  // 8/512 = 0.0156
  CHECK(depthsFor({0.001, 0}, large).boundary == 10);
  CHECK(depthsFor({100.0, 0}, large).boundary == 0);
  CHECK(depthsFor({6, 4}, large).boundary == 6);
  CHECK(depthsFor({6, 4}, large).interior == 4);
  CHECK(depthsFor({0.1, 5}, small).interior == 3);
}

TEST_CASE("levels of detail that make no sense are refused") {
  CHECK_NOTHROW(checkDetail({10, 10}));
  CHECK_NOTHROW(checkDetail({0.02, 4}));
  CHECK_THROWS_AS(checkDetail({11, 0}), InputError);
  CHECK_THROWS_AS(checkDetail({-1, 0}), InputError);
  CHECK_THROWS_AS(checkDetail({6, 7}), InputError);
  CHECK_THROWS_AS(checkDetail({0.02, 11}), InputError);
  CHECK_THROWS_AS(checkDetail({0.0, 0}), InputError);
  CHECK_THROWS_AS(checkDetail({-0.1, 0}), InputError);
  CHECK_THROWS_AS(checkDetail({std::numeric_limits<double>::quiet_NaN(), 0}), InputError);
}
