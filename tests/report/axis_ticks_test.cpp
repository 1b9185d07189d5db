#include "report/axis_ticks.h"

#include <algorithm>
#include <cmath>

#include "mesh/random.h"
#include "test_support.h"

using namespace haarlight;

namespace {

using Numbers = std::vector<double>;

/// Whether a number is 1, 2 or 5 times a power of ten.
bool isRound(double number) {
  const double mantissa = number / std::pow(10, std::floor(std::log10(number) + 1e-9));
  return std::ranges::any_of(Numbers{1, 2, 5},
                             [&](double m) { return std::abs(mantissa - m) < 1e-9; });
}

/// A range of any size and place.
std::pair<double, double> randomRange(Random& random) {
  const auto number = [&] {
    return (random.uniform() - 0.5) * std::pow(10, 12 * random.uniform() - 6);
  };
  const double a = number(), b = number();
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

TEST_CASE("linear ticks of known ranges") {
  CHECK(linearTicks(0, 1) == Numbers{0, 0.2, 0.4, 0.6, 0.8, 1});
  CHECK(linearTicks(0, 0.31) == Numbers{0, 0.1, 0.2, 0.3, 0.4});
  CHECK(linearTicks(3, 158, 8) == Numbers{0, 20, 40, 60, 80, 100, 120, 140, 160});
  CHECK(linearTicks(-0.03, 0.07) == Numbers{-0.04, -0.02, 0, 0.02, 0.04, 0.06, 0.08});
  CHECK(linearTicks(0, 0) == Numbers{0, 0.2});
  CHECK(linearTicks(5, 5) == Numbers{5, 6});
}

TEST_CASE("linear ticks are round, even and cover the range without much waste") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto [lower, upper] = randomRange(random);
    const Numbers ticks = linearTicks(lower, upper);
    CAPTURE(lower);
    CAPTURE(upper);
    REQUIRE(ticks.size() >= 2);
    CHECK(ticks.size() <= 7);
    CHECK(ticks.front() <= lower);
    CHECK(ticks.back() >= upper);
    const double step = ticks[1] - ticks[0];
    CHECK(isRound(step));
    CHECK(ticks.front() > lower - step * (1 + 1e-9));
    CHECK(ticks.back() < upper + step * (1 + 1e-9));
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      CHECK(std::abs(ticks[k] - (ticks[0] + double(k) * step)) < 1e-9 * step * double(k + 1));
      CHECK(std::abs(std::remainder(ticks[k], step)) < 1e-6 * step);
      CHECK(std::stod(tickLabel(ticks[k])) == ticks[k]);
    }
  }
}

TEST_CASE("logarithmic ticks of known ranges") {
  CHECK(logarithmicTicks(0.07, 0.9) == Numbers{0.05, 0.1, 0.2, 0.5, 1});
  CHECK(logarithmicTicks(0.001, 0.05) == Numbers{0.001, 0.002, 0.005, 0.01, 0.02, 0.05});
  CHECK(logarithmicTicks(0.002, 30) == Numbers{0.001, 0.01, 0.1, 1, 10, 100});
  CHECK(logarithmicTicks(3, 3) == Numbers{2, 5});
  CHECK(logarithmicTicks(10, 10) == Numbers{10, 20});
}

TEST_CASE("logarithmic ticks are round and cover the range closely") {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double lower = std::pow(10, 16 * random.uniform() - 8);
    const double upper = lower * std::pow(10, 6 * random.uniform());
    CAPTURE(lower);
    CAPTURE(upper);
    const Numbers ticks = logarithmicTicks(lower, upper);
    REQUIRE(ticks.size() >= 2);
    CHECK(ticks.size() <= 12);
    CHECK(ticks[0] <= lower);
    CHECK(ticks[1] > lower);
    CHECK(ticks.back() >= upper);
    if (ticks.size() > 2) CHECK(ticks[ticks.size() - 2] < upper);
    CHECK(std::ranges::all_of(ticks, isRound));
    CHECK(std::ranges::is_sorted(ticks));
  }
}

TEST_CASE("labels of ticks are short") {
  CHECK(tickLabel(linearTicks(0, 0.5)[3]) == "0.3");
  CHECK(tickLabel(0) == "0");
  CHECK(tickLabel(-20) == "-20");
  CHECK(tickLabel(100000) == "100000");
  CHECK(tickLabel(0.00002) == "0.00002");
  CHECK(tickLabel(1e12) == "1e+12");
}
