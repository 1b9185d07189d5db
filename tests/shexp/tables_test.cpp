#include "shexp/tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sh/zonal.h"
#include "shexp/zonal_functions.h"

using namespace haarlight;

TEST_CASE("rows hold the rotated logarithm's factors, and between rows little is lost") {
  for (const int order : {4, 5, 6}) {
    const ShexpTables tables(order);
    double largest = 0;
    for (int step = 0; step < 10 * ShexpTables::logarithmRows; ++step) {
      const double scaled = step / 10.0;
      const int row = int(scaled);
      const auto exact = convolutionFactors(
          zonalLogarithm(capVisibility(order, scaled / ShexpTables::logarithmRows)));
      for (int l = 0; l < order; ++l) {
        const float* own = &tables.logarithms[row * ShexpTables::logarithmRowSize];
        const double error = std::abs(own[l] + (scaled - row) * own[8 + l] - exact[l]);
        if (step % 10 == 0) REQUIRE(error < 1e-5);
        largest = std::fmax(largest, error);
      }
    }
    MESSAGE("order ", order, ": largest error between rows ", largest);
    CHECK(largest < 0.2);
    for (std::size_t i = 0; i < tables.logarithms.size(); ++i)
      if (int(i % 8) >= order) REQUIRE(tables.logarithms[i] == 0);
  }
}

TEST_CASE("the linear exponential starts at 1 + f") {
  const ShexpTables tables(4);
  CHECK(tables.linear.front().x == doctest::Approx(std::sqrt(4 * std::acos(-1.0))));
  CHECK(tables.linear.front().y == 1.0f);
  for (int row = 1; row <= ShexpTables::linearRows; ++row) {
    CHECK(tables.linear[row].x > tables.linear[row - 1].x);  // the mean of exp f is at least 1
    CHECK(tables.linear[row].y < tables.linear[row - 1].y);  // spheres: f̂ is skewed downwards
  }
}

TEST_CASE("terms of squares are sorted and even in number, and each product appears once") {
  const ShexpTables tables(6);
  CHECK(tables.squareStarts.size() == 37);
  CHECK(tables.squareStarts.back() == tables.squareTerms.size());
  int fillers = 0;
  for (int k = 0; k < 36; ++k) {
    const auto begin = tables.squareStarts[k], end = tables.squareStarts[k + 1];
    REQUIRE((end - begin) % 2 == 0);
    for (auto i = begin; i < end; ++i) {
      const ShexpSquareTerm& term = tables.squareTerms[i];
      REQUIRE(term.first <= term.second);
      if (term.weight == 0) {
        ++fillers;
        REQUIRE(i == end - 1);
      } else if (i > begin) {
        const ShexpSquareTerm& before = tables.squareTerms[i - 1];
        REQUIRE(before.first * 36 + before.second < term.first * 36 + term.second);
      }
    }
  }
  CHECK(fillers < 36);
}

TEST_CASE("orders and limits out of range are refused") {
  CHECK_THROWS_AS(ShexpTables(1), std::invalid_argument);
  CHECK_THROWS_AS(ShexpTables(7), std::invalid_argument);
  CHECK_THROWS_AS(ShexpTables(4, 0), std::invalid_argument);
  CHECK_THROWS_AS(ShexpTables(4, std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(ShexpTables(4, 50), std::invalid_argument);
}
