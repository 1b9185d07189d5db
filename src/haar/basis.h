#pragma once

/// The Haar basis on a cube face (method.md §4): its functions and how they are numbered.
///
/// A face is the unit square; x runs with the columns (s), y with the rows (t). The scaling
/// function Φ is 1. At level l = 0 … 4 the square (row, column) of the 2^l × 2^l grid carries three
/// wavelets:
///
///   horizontal (Ψ01)  + +   vertical (Ψ10)  + +   diagonal (Ψ11)  + −      all times 2^l
///      + on the left  left  + on the top    top   checkerboard    − +
///
/// Coefficient 0 belongs to Φ; the wavelet of type M on square q = row·2^l + column of level l has
/// index 4^l + 3q + M. So level l occupies [4^l, 4^(l+1)), and the first 4^l coefficients of a face
/// describe it at a resolution of 2^l × 2^l.
///
/// The mean of a function over square q of level l has index (4^l − 1)/3 + q in a mean pyramid. The
/// paper's psum(X, square), which adds the signed coarser wavelets, is this mean.

#include <array>

#include "cube/cube_map.h"

namespace haarlight {

inline constexpr int haarLevels = 5;
inline constexpr int coefficientsPerFace = texelsPerFace;
/// Squares of levels 0 … 4.
inline constexpr int meansPerFace = 341;

/// Level 1 storage of the paper (§3.4): everything of an 8×8 face.
inline constexpr int coarseLevels = 3;
inline constexpr int coarseCoefficientsPerFace = 64;
inline constexpr int coarseMeansPerFace = 21;

enum WaveletType { horizontalWavelet = 0, verticalWavelet = 1, diagonalWavelet = 2 };

constexpr int squaresPerSide(int level) {
  return 1 << level;
}
constexpr int firstCoefficient(int level) {
  return 1 << (2 * level);
}
constexpr int firstMean(int level) {
  return ((1 << (2 * level)) - 1) / 3;
}

constexpr int coefficientIndex(int level, int square, int type) {
  return firstCoefficient(level) + 3 * square + type;
}
constexpr int meanIndex(int level, int square) {
  return firstMean(level) + square;
}

/// Index within the next finer level of the top-left quarter of a square.
constexpr int firstChild(int level, int square) {
  const int side = squaresPerSide(level);
  return 4 * side * (square / side) + 2 * (square % side);
}

/// The four quarters of a square: top-left, top-right, bottom-left, bottom-right.
constexpr std::array<int, 4> children(int level, int square) {
  const int first = firstChild(level, square), below = first + 2 * squaresPerSide(level);
  return {first, first + 1, below, below + 1};
}

/// A wavelet of a face.
struct Wavelet {
  int level;
  int square;
  int type;
};

/// The wavelet with coefficient index 1 … 1023.
constexpr Wavelet waveletAt(int coefficient) {
  int level = 0;
  while (firstCoefficient(level + 1) <= coefficient) ++level;
  const int offset = coefficient - firstCoefficient(level);
  return {level, offset / 3, offset % 3};
}

/// Sign of a wavelet of `type` on the quarter `child` (order of children()).
constexpr int waveletSign(int type, int child) {
  const bool right = child & 1, bottom = child & 2;
  const bool minus = type == horizontalWavelet ? right
                     : type == verticalWavelet ? bottom
                                               : right != bottom;
  return minus ? -1 : 1;
}

}  // namespace haarlight
