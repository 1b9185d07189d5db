#include "haar/triple_product.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace haarlight;

namespace {

/// Values of the first 64 basis functions on an 8×8 face.
std::vector<std::array<double, 64>> coarseBasis() {
  std::vector<std::array<double, 64>> basis(64);
  for (int i = 0; i < 64; ++i) {
    std::vector<double> coefficients(coefficientsPerFace);
    coefficients[i] = 1;
    const auto texels = haarInverse<double, double>(std::span<const double>(coefficients));
    for (int p = 0; p < 64; ++p) basis[i][p] = texels[p / 8 * 4 * faceSize + p % 8 * 4];
  }
  return basis;
}

}  // namespace

TEST_CASE("the non-zero triple coefficients of an 8×8 face are those of the theorem") {
  const auto basis = coarseBasis();
  constexpr int N = 64, log4N = 3;
  int ordered = 0, pairedFirst = 0;
  for (int u = 0; u < N; ++u)
    for (int v = 0; v < N; ++v)
      for (int w = 0; w < N; ++w) {
        double integral = 0;
        for (int p = 0; p < N; ++p) integral += basis[u][p] * basis[v][p] * basis[w][p] / N;
        REQUIRE(tripleCoefficient(u, v, w) == integral);
        if (integral == 0) continue;
        ++ordered;
        pairedFirst += u == v || (v != w && u != w);
      }
  // The paper's 2 − N + 3N log₄N counts condition (2) in all six orders, but a pair and its third
  // of condition (3) once, whichever of the three functions the third belongs to.
  CHECK(pairedFirst == 2 - N + 3 * N * log4N);
  // As ordered index triples condition (3) has three orders.
  const int conditionThree = pairedFirst - 1 - 2 * (N - 1);
  CHECK(ordered == pairedFirst + 2 * conditionThree);
}

TEST_CASE("the triple product of 1,000 random samples equals the sum over texels") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int sample = 0; sample < 1000; ++sample) {
    double texelSum = 0, waveletSum = 0;
    for (int face = 0; face < faceCount; ++face) {
      std::vector<double> light(texelsPerFace), visibility(texelsPerFace), lobe(texelsPerFace);
      for (int i = 0; i < texelsPerFace; ++i) {
        light[i] = uniform(random) < 0.01 ? 1000 * uniform(random) : uniform(random);
        visibility[i] = uniform(random) < 0.5;
        lobe[i] = uniform(random);
        texelSum += light[i] * visibility[i] * lobe[i] / texelsPerFace;
      }
      waveletSum +=
          tripleProduct(haarForward<double, double>(light), haarForward<double, double>(visibility),
                        haarForward<double, double>(lobe));
    }
    REQUIRE(std::abs(waveletSum - texelSum) <= 1e-6 * texelSum);
  }
}
