#include "haar/transform.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace haarlight;

namespace {

std::vector<double> randomFace(int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> texels(texelsPerFace);
  for (double& texel : texels) texel = value(random);
  return texels;
}

/// Value of a basis function at a texel, straight from the definition Ψ(2^l x − i, 2^l y − j)·2^l.
double basisValue(int coefficient, int row, int column) {
  if (coefficient == 0) return 1;
  const Wavelet w = waveletAt(coefficient);
  const int side = 1 << w.level, texels = faceSize / side;
  if (row / texels != w.square / side || column / texels != w.square % side) return 0;
  const double x = (column % texels + 0.5) / texels, y = (row % texels + 0.5) / texels;
  const double left = x < 0.5 ? 1 : -1, top = y < 0.5 ? 1 : -1;
  return side * (w.type == 0 ? left : w.type == 1 ? top : left * top);
}

}  // namespace

TEST_CASE("coefficient indices and wavelets correspond one to one") {
  for (int i = 1; i < coefficientsPerFace; ++i) {
    const Wavelet w = waveletAt(i);
    REQUIRE(coefficientIndex(w.level, w.square, w.type) == i);
  }
}

TEST_CASE("every coefficient is the inner product with its basis function") {
  const auto texels = randomFace(1);
  const auto face = haarForward<double, double>(texels);
  for (int i = 0; i < coefficientsPerFace; ++i) {
    double inner = 0;
    for (int texel = 0; texel < texelsPerFace; ++texel)
      inner += texels[texel] * basisValue(i, texel / faceSize, texel % faceSize) / texelsPerFace;
    REQUIRE(face.coefficients[i] == doctest::Approx(inner).epsilon(1e-12));
  }
}

TEST_CASE("forward then inverse is the identity") {
  const auto texels = randomFace(2);
  const auto face = haarForward<double, double>(texels);
  const auto back = haarInverse<double, double>(std::span(face.coefficients));
  for (int i = 0; i < texelsPerFace; ++i) REQUIRE(std::abs(back[i] - texels[i]) < 1e-14);
}

TEST_CASE("forward then inverse returns a 0/1 image bit for bit in single precision") {
  std::mt19937 random(3);
  std::vector<float> texels(texelsPerFace);
  for (float& texel : texels) texel = float(random() & 1);
  const auto face = haarForward<float, float>(texels);
  CHECK(haarInverse<float, float>(std::span(face.coefficients)) == texels);
}

TEST_CASE("the transform keeps the inner product (Parseval)") {
  const auto f = randomFace(4), g = randomFace(5);
  const auto F = haarForward<double, double>(f), G = haarForward<double, double>(g);
  double texelSum = 0, coefficientSum = 0;
  for (int i = 0; i < texelsPerFace; ++i) {
    texelSum += f[i] * g[i] / texelsPerFace;
    coefficientSum += F.coefficients[i] * G.coefficients[i];
  }
  CHECK(coefficientSum == doctest::Approx(texelSum).epsilon(1e-12));
}

TEST_CASE("psum, Φ plus the signed coarser wavelets, is the mean over the square") {
  const auto texels = randomFace(6);
  const auto face = haarForward<double, double>(texels);
  for (int level = 0; level < haarLevels; ++level)
    for (int square = 0; square < squaresPerSide(level) * squaresPerSide(level); ++square) {
      const int texelsPerSquare = faceSize >> level;
      const int row = square / squaresPerSide(level) * texelsPerSquare;
      const int column = square % squaresPerSide(level) * texelsPerSquare;
      double psum = 0, mean = 0;
      for (int i = 0; i < firstCoefficient(level); ++i)
        psum += face.coefficients[i] * basisValue(i, row, column);
      for (int i = 0; i < texelsPerSquare * texelsPerSquare; ++i)
        mean += texels[(row + i / texelsPerSquare) * faceSize + column + i % texelsPerSquare] /
                (texelsPerSquare * texelsPerSquare);
      REQUIRE(face.mean(level, square) == doctest::Approx(mean).epsilon(1e-12));
      REQUIRE(std::abs(psum - mean) < 1e-13);
    }
}
