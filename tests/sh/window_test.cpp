#include "sh/window.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sh/zonal.h"

using namespace haarlight;

namespace {

/// The deepest undershoot of a zonal function over the sphere.
double lowestValue(const ShVector<double>& f) {
  double lowest = 0;
  for (int i = 0; i <= 400; ++i) {
    const double angle = std::numbers::pi * i / 400;
    lowest = std::min(lowest, evaluate(f, {std::sin(angle), 0, std::cos(angle)}));
  }
  return lowest;
}

}  // namespace

TEST_CASE("windows have their closed forms") {
  const auto hanning = windowFactors(ShWindow::hanning, 4, 6);
  const auto lanczos = windowFactors(ShWindow::lanczos, 4, 6);
  CHECK(hanning[0] == 1);
  CHECK(hanning[1] == doctest::Approx((1 + std::numbers::sqrt2 / 2) / 2));
  CHECK(hanning[2] == doctest::Approx(0.5));
  CHECK(lanczos[0] == 1);
  CHECK(lanczos[1] == doctest::Approx(2 * std::numbers::sqrt2 / std::numbers::pi));
  CHECK(lanczos[2] == doctest::Approx(2 / std::numbers::pi));
  for (const int l : {4, 5}) {
    CHECK(hanning[l] == 0);
    CHECK(lanczos[l] == 0);
  }
}

TEST_CASE("windows fall with the band and grow with the width") {
  for (const ShWindow window : {ShWindow::hanning, ShWindow::lanczos})
    for (int width = 2; width < 12; ++width) {
      const auto narrow = windowFactors(window, width, 10);
      const auto wide = windowFactors(window, width + 0.5, 10);
      for (int l = 1; l < 10; ++l) {
        REQUIRE(narrow[l] <= narrow[l - 1]);
        REQUIRE(wide[l] >= narrow[l]);
      }
    }
}

TEST_CASE("a window damps the swings of a small bright light and keeps its power") {
  const auto light = rotateZonal(projectZonal(
                                     6, [](double) { return 1.0; }, 0.9, 1),
                                 {0, 0, 1});
  const auto lanczos = applyWindow(light, ShWindow::lanczos);
  const auto hanning = applyWindow(light, ShWindow::hanning);
  const double plainDip = lowestValue(light), lanczosDip = lowestValue(lanczos),
               hanningDip = lowestValue(hanning);
  MESSAGE("lowest value: plain ", plainDip, ", Lanczos ", lanczosDip, ", Hanning ", hanningDip);
  CHECK(plainDip < -0.05);
  CHECK(lanczosDip > plainDip / 3);
  CHECK(hanningDip > lanczosDip);
  CHECK(hanning[0] == light[0]);
  CHECK(applyWindow(light, ShWindow::hanning, 6) == hanning);
}

TEST_CASE("windows without width are refused") {
  CHECK_THROWS_AS(windowFactors(ShWindow::hanning, 0, 4), std::invalid_argument);
  CHECK_THROWS_AS(windowFactors(ShWindow::lanczos, -1, 4), std::invalid_argument);
  CHECK_THROWS_AS(windowFactors(ShWindow::lanczos, std::nan(""), 4), std::invalid_argument);
  CHECK_THROWS_AS(windowFactors(ShWindow::lanczos, 4, 0), std::invalid_argument);
}
