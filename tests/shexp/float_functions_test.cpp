#include "shexp/float_functions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace haarlight;

TEST_CASE("the inverse root is within 2e-7 over all magnitudes") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-37, 37);
  double largest = 0;
  for (int i = 0; i < 200000; ++i) {
    const float x = std::pow(10.0f, exponent(random));
    largest = std::fmax(largest, std::abs(inverseSquareRoot(x) * std::sqrt(double(x)) - 1));
  }
  MESSAGE("largest relative error ", largest);
  CHECK(largest < 2e-7);
  CHECK(std::isfinite(inverseSquareRoot(0)));
}

TEST_CASE("the exponential is within 3e-7 over its range and held beyond") {
  double largest = 0;
  for (int i = -87000; i <= 87000; ++i) {
    const float x = float(i) / 1000;
    largest = std::fmax(largest, std::abs(exponential(x) / std::exp(double(x)) - 1));
  }
  MESSAGE("largest relative error ", largest);
  CHECK(largest < 3e-7);
  CHECK(exponential(0) == 1);
  CHECK(exponential(1000) == exponential(87));
  CHECK(exponential(-1000) == exponential(-87));
}
