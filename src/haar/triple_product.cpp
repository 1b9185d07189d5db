#include "haar/triple_product.h"

namespace haarlight {

namespace {

/// Terms of one square: condition (2), and condition (3) for each of its three wavelets.
double squareTerms(const HaarFace<double>& L, const HaarFace<double>& V, const HaarFace<double>& p,
                   int level, int square) {
  const auto coefficient = [&](const HaarFace<double>& face, int type) {
    return face.coefficient({level, square, type});
  };
  double sameSquare = 0, sameWavelet = 0;
  for (int type = 0; type < 3; ++type) {
    const int second = (type + 1) % 3, third = (type + 2) % 3;
    const double Lm = coefficient(L, type), Vm = coefficient(V, type), pm = coefficient(p, type);
    sameSquare += Lm * (coefficient(V, second) * coefficient(p, third) +
                        coefficient(V, third) * coefficient(p, second));
    sameWavelet += pm * Lm * V.mean(level, square) + Vm * pm * L.mean(level, square) +
                   Lm * Vm * p.mean(level, square);
  }
  return squaresPerSide(level) * sameSquare + sameWavelet;
}

/// Square of the coarser `level` that a finer square lies in, and the quarter of it.
struct Ancestor {
  int square;
  int child;
};

Ancestor ancestorOf(const Wavelet& fine, int level) {
  const int side = squaresPerSide(fine.level), shift = fine.level - level;
  const int row = fine.square / side, column = fine.square % side;
  return {(row >> shift) * squaresPerSide(level) + (column >> shift),
          2 * (row >> (shift - 1) & 1) + (column >> (shift - 1) & 1)};
}

/// ∫ w² t = mean of t over the square of w, for t strictly coarser or Φ (coefficient 0).
double meanOfCoarser(const Wavelet& pair, int third) {
  if (third == 0) return 1;
  const Wavelet coarse = waveletAt(third);
  if (coarse.level >= pair.level) return 0;
  const auto [square, child] = ancestorOf(pair, coarse.level);
  if (square != coarse.square) return 0;
  return waveletSign(coarse.type, child) * squaresPerSide(coarse.level);
}

}  // namespace

double tripleProduct(const HaarFace<double>& light, const HaarFace<double>& visibility,
                     const HaarFace<double>& lobe) {
  double sum = lobe.coefficients[0] * light.coefficients[0] * visibility.coefficients[0];
  for (int level = 0; level < haarLevels; ++level)
    for (int square = 0; square < squaresPerSide(level) * squaresPerSide(level); ++square)
      sum += squareTerms(light, visibility, lobe, level, square);
  return sum;
}

double tripleProduct(const HaarCube<double>& light, const HaarCube<double>& visibility,
                     const HaarCube<double>& lobe) {
  double sum = 0;
  for (int face = 0; face < faceCount; ++face)
    sum += tripleProduct(light[face], visibility[face], lobe[face]);
  return sum;
}

double tripleCoefficient(int u, int v, int w) {
  if (u == 0 && v == 0 && w == 0) return 1;
  if (u == v && u != 0) return meanOfCoarser(waveletAt(u), w);
  if (v == w && v != 0) return meanOfCoarser(waveletAt(v), u);
  if (u == w && u != 0) return meanOfCoarser(waveletAt(u), v);
  if (u == 0 || v == 0 || w == 0) return 0;
  const Wavelet a = waveletAt(u), b = waveletAt(v), c = waveletAt(w);
  const bool sameSquare =
      a.level == b.level && b.level == c.level && a.square == b.square && b.square == c.square;
  return sameSquare ? squaresPerSide(a.level) : 0;
}

}  // namespace haarlight
