#include "sh/cube_basis.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "sh/projection.h"
#include "sh/random_functions.h"

using namespace haarlight;
using haarlight::test::largestDifference;

namespace {

constexpr double pi = std::numbers::pi;

/// ∫ y_i dω over a texel of a finer grid's cells that make it up.
std::vector<double> sumOfParts(const CubeBasis& fine, int fineSize, int texel, int coarseSize) {
  const int parts = fineSize / coarseSize, face = texel / (coarseSize * coarseSize);
  const int row = texel / coarseSize % coarseSize, column = texel % coarseSize;
  std::vector<double> sum(shCoefficientCount(fine.order()));
  for (int i = 0; i < parts * parts; ++i) {
    const int r = row * parts + i / parts, c = column * parts + i % parts;
    const auto part = fine.integrals((face * fineSize + r) * fineSize + c);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
  }
  return sum;
}

}  // namespace

TEST_CASE("a texel's integrals of bands 0 and 1 are its solid angle and first moment") {
  const CubeBasis& table = CubeBasis::shared(2);
  const double constant = 0.5 / std::sqrt(pi), linear = std::sqrt(0.75 / pi);
  double error = 0;
  for (int texel = 0; texel < texelCount; ++texel) {
    const auto integrals = table.integrals(texel);
    const glm::dvec3 moment = texelMoment(texel);
    const double expected[] = {constant * texelSolidAngle(texel), -linear * moment.y,
                               linear * moment.z, -linear * moment.x};
    for (int i = 0; i < 4; ++i) error = std::fmax(error, std::abs(integrals[i] - expected[i]));
  }
  MESSAGE("largest error ", error);
  CHECK(error < 1e-15);
}

TEST_CASE("a constant light has one coefficient, a face of it that of the solid angle") {
  CubeImage<double> light;
  for (double& texel : light.texels) texel = 2;
  const auto f = projectToSh(20, light);
  CHECK(f[0] == doctest::Approx(2 * std::sqrt(4 * pi)).epsilon(1e-14));
  for (int i = 1; i < f.size(); ++i) REQUIRE(std::abs(f[i]) < 1e-13);
}

TEST_CASE("integrals over large and small texels agree, at order 20") {
  // Fewer and more points, over parts and over the whole: both are exact or this fails.
  const CubeBasis table(20, 8), fine(20, 32);
  for (int size : {1, 2, 4, 16}) {
    const CubeBasis coarse(20, size);
    const bool finer = size > 8;
    double error = 0;
    for (int texel = 0; texel < faceCount * std::min(size, 8) * std::min(size, 8); ++texel) {
      const auto parts =
          finer ? sumOfParts(coarse, size, texel, 8) : sumOfParts(table, 8, texel, size);
      const auto whole = finer ? table.integrals(texel) : coarse.integrals(texel);
      for (int i = 0; i < 400; ++i) error = std::fmax(error, std::abs(parts[i] - whole[i]));
    }
    MESSAGE("faces of ", size, " and 8 texels: ", error);
    CHECK(error < 1e-13);
  }
  double error = 0;
  for (int texel = 0; texel < faceCount * 64; ++texel) {
    const auto parts = sumOfParts(fine, 32, texel, 8);
    for (int i = 0; i < 400; ++i)
      error = std::fmax(error, std::abs(parts[i] - table.integrals(texel)[i]));
  }
  CHECK(error < 1e-13);
}

TEST_CASE("a linear light sampled at finer and finer texels has its analytic coefficients") {
  // The mean of a linear function over a texel is its moment over its solid angle.
  const double linear = std::sqrt(0.75 / pi);
  CubeImage<double> light;
  double expected = 0;
  for (int texel = 0; texel < texelCount; ++texel) {
    light[texel] = texelMoment(texel).z / texelSolidAngle(texel);
    expected += linear * light[texel] * texelMoment(texel).z;
  }
  const auto f = projectToSh(5, light);
  CHECK(f.at(1, 0) == doctest::Approx(expected).epsilon(1e-13));
  CHECK(f.at(1, 0) == doctest::Approx(linear * 4 * pi / 3).epsilon(1e-3));
  CHECK(std::abs(f.at(1, 1)) < 1e-14);
  CHECK(std::abs(f[0]) < 1e-14);
}

TEST_CASE("quadrature of the cube agrees with many samples of it") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0, 1);
  RadianceCube light;
  for (glm::vec3& texel : light.texels) texel = {value(random), value(random), value(random)};
  const auto exact = projectToSh(4, light);
  const auto sampled = projectToSh(4, productRule(500, 1000), [&](const glm::dvec3& d) {
    return glm::dvec3(light[texelAt(d)]);
  });
  for (int i = 0; i < 16; ++i)
    for (int channel = 0; channel < 3; ++channel)
      REQUIRE(std::abs(exact[i][channel] - sampled[i][channel]) < 5e-3);
}

TEST_CASE("single and double precision differ by rounding, colours are three channels") {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> value(0, 1);
  RadianceCube light;
  CubeImage<double> green;
  for (int texel = 0; texel < texelCount; ++texel) {
    light[texel] = {0, value(random), 0};
    green[texel] = light[texel].y;
  }
  const auto coloured = projectToSh(6, light);
  const auto expected = projectToSh(6, green);
  for (int i = 0; i < 36; ++i) CHECK(coloured[i].y == float(expected[i]));
}

TEST_CASE("wrong orders and sizes are refused") {
  const std::vector<float> texels(24);
  CHECK(CubeBasis(3, 2).project<float>(texels).size() == 9);
  CHECK_THROWS_AS(CubeBasis(3, 4).project<float>(texels), std::invalid_argument);
  CHECK_THROWS_AS(CubeBasis(0), std::invalid_argument);
  CHECK_THROWS_AS(CubeBasis(3, 0), std::invalid_argument);
  CHECK_THROWS_AS(projectToSh(0, CubeImage<float>()), std::invalid_argument);
}
