#include "sh/vector.h"

#include <doctest/doctest.h>

#include <stdexcept>

#include "sh/random_functions.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("sums, multiples and values at a direction go together") {
  std::mt19937 random(1);
  const auto f = randomFunction(7, random), g = randomFunction(7, random);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 d = randomDirection(random);
    const double expected = 2 * evaluate(f, d) - 3 * (evaluate(g, d) - evaluate(f, d));
    CHECK(evaluate(2.0 * f - (g - f) * 3.0, d) == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("a coloured function is its three channels") {
  std::mt19937 random(2);
  const auto red = randomFunction(4, random), green = randomFunction(4, random),
             blue = randomFunction(4, random), lobe = randomFunction(4, random);
  ShVector<glm::dvec3> light(4);
  for (int i = 0; i < light.size(); ++i) light[i] = {red[i], green[i], blue[i]};
  const glm::dvec3 colour = dot(light, lobe);
  CHECK(colour.x == doctest::Approx(dot(red, lobe)).epsilon(1e-12));
  CHECK(colour.y == doctest::Approx(dot(green, lobe)).epsilon(1e-12));
  CHECK(colour.z == doctest::Approx(dot(blue, lobe)).epsilon(1e-12));
  const glm::dvec3 d = randomDirection(random);
  CHECK(evaluate(light, d).y == doctest::Approx(evaluate(green, d)).epsilon(1e-12));
  const double squares = dot(red, red) + dot(green, green) + dot(blue, blue);
  double bands = 0;
  for (int l = 0; l < 4; ++l) bands += bandNorm(light, l) * bandNorm(light, l);
  CHECK(bands == doctest::Approx(squares).epsilon(1e-12));
}

TEST_CASE("bands and places are ranges of the coefficients") {
  ShVector<float> f(3);
  for (int i = 0; i < f.size(); ++i) f[i] = float(i);
  CHECK(f.band(0).size() == 1);
  CHECK(f.band(2).size() == 5);
  CHECK(f.band(2)[0] == 4.0f);
  CHECK(f.at(2, 2) == 8.0f);
  CHECK(bandNorm(f, 1) == doctest::Approx(std::sqrt(14.0)));
}

TEST_CASE("another order drops bands or adds bands of zeros") {
  std::mt19937 random(3);
  const auto f = randomFunction(5, random);
  CHECK(f.withOrder(9).withOrder(5) == f);
  CHECK(f.withOrder(9).at(8, 0) == 0);
  CHECK(f.withOrder(2).at(1, 1) == f.at(1, 1));
}

TEST_CASE("bands are scaled one by one") {
  std::mt19937 random(4);
  const auto f = randomFunction(3, random);
  const double factors[] = {1, 0.5, 0};
  const auto scaled = scaleBands(f, factors);
  CHECK(scaled.at(0, 0) == f.at(0, 0));
  CHECK(scaled.at(1, -1) == 0.5 * f.at(1, -1));
  CHECK(bandNorm(scaled, 2) == 0);
}

TEST_CASE("functions of different orders and wrong sizes are refused") {
  ShVector<double> f(3);
  const ShVector<double> g(4);
  CHECK_THROWS_AS(ShVector<double>(0), std::invalid_argument);
  CHECK_THROWS_AS(ShVector<double>(-2), std::invalid_argument);
  CHECK_THROWS_AS(ShVector<double>(3, std::vector<double>(8)), std::invalid_argument);
  CHECK_THROWS_AS(f += g, std::invalid_argument);
  CHECK_THROWS_AS(f -= g, std::invalid_argument);
  CHECK_THROWS_AS(dot(f, g), std::invalid_argument);
  CHECK_THROWS_AS(scaleBands(f, std::vector<double>(4)), std::invalid_argument);
  CHECK_THROWS_AS(f.withOrder(0), std::invalid_argument);
}
