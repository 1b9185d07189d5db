#include "benchmark/power_law.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace haarlight::benchmark;

namespace {

std::vector<glm::dvec2> pointsOf(const std::function<double(double)>& seconds, double first = 8,
                                 double last = 1024) {
  std::vector<glm::dvec2> points;
  for (double size = first; size <= last; size *= 2) points.emplace_back(size, seconds(size));
  return points;
}

}  // namespace

TEST_CASE("exact power laws have their exponent in every fit") {
  for (const double exponent : {0.5, 1.0, 1.37, 2.0}) {
    CAPTURE(exponent);
    const auto law = fitPowerLaw(pointsOf([&](double n) { return 3e-6 * std::pow(n, exponent); }));
    REQUIRE(law);
    CHECK(law->exponent == doctest::Approx(exponent).epsilon(1e-9));
    CHECK(law->upperHalfExponent == doctest::Approx(exponent).epsilon(1e-9));
    CHECK(law->exponentAboveFixed == doctest::Approx(exponent).epsilon(1e-4));
    CHECK(law->fixedSeconds < 1e-4 * 3e-6 * std::pow(8, exponent));
  }
}

TEST_CASE("a fixed cost hides growth from slopes, and is found") {
  const auto law = fitPowerLaw(pointsOf([](double n) { return 0.02 + 1e-4 * n; }));
  REQUIRE(law);
  CHECK(law->exponent < 0.5);
  CHECK(law->upperHalfExponent > law->exponent);
  CHECK(law->upperHalfExponent < 1);
  CHECK(law->exponentAboveFixed == doctest::Approx(1).epsilon(1e-4));
  CHECK(law->fixedSeconds == doctest::Approx(0.02).epsilon(1e-4));
}

TEST_CASE("size 0 tells the fixed cost and does not count for slopes") {
  auto points = pointsOf([](double n) { return 0.5 + 0.01 * n; });
  const auto without = fitPowerLaw(points);
  points.insert(points.begin(), {0, 0.5});
  const auto with = fitPowerLaw(points);
  REQUIRE(with);
  CHECK(with->exponent == without->exponent);
  CHECK(with->upperHalfExponent == without->upperHalfExponent);
  CHECK(with->fixedSeconds == doctest::Approx(0.5).epsilon(1e-4));
  CHECK(with->exponentAboveFixed == doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("the same time at every size is a fixed cost") {
  const auto law = fitPowerLaw(pointsOf([](double) { return 0.25; }));
  REQUIRE(law);
  CHECK(law->exponent == doctest::Approx(0).epsilon(1e-12));
  CHECK(law->upperHalfExponent == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("the slope is that of least squares") {
  // log n = 0, 1, 2, 3 and log seconds = 0, 1, 1, 2: slope 3/5.
  std::vector<glm::dvec2> points;
  for (const auto& [x, y] : {std::pair(0, 0), {1, 1}, {2, 1}, {3, 2}})
    points.emplace_back(std::exp(x), std::exp(y));
  CHECK(fitPowerLaw(points)->exponent == doctest::Approx(0.6).epsilon(1e-12));
}

TEST_CASE("three sizes are too few") {
  CHECK(!fitPowerLaw(pointsOf([](double n) { return n; }, 8, 32)));
  CHECK(fitPowerLaw(pointsOf([](double n) { return n; }, 8, 64)));
  CHECK(!fitPowerLaw({}));
}
