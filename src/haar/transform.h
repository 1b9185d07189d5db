#pragma once

/// The Haar transform of one cube face and its inverse (method.md §4).

#include <array>
#include <span>
#include <vector>

#include "haar/basis.h"

namespace haarlight {

/// A face in the Haar basis. `Value` is a floating-point number or a GLM vector of them.
template <typename Value>
struct HaarFace {
  /// Coefficients in the order of haar/basis.h.
  std::vector<Value> coefficients = std::vector<Value>(coefficientsPerFace, Value{});
  /// Means over the squares of levels 0 … 4.
  std::vector<Value> means = std::vector<Value>(meansPerFace, Value{});

  const Value& coefficient(const Wavelet& w) const {
    return coefficients[coefficientIndex(w.level, w.square, w.type)];
  }
  const Value& mean(int level, int square) const { return means[meanIndex(level, square)]; }
};

/// All six faces.
template <typename Value>
using HaarCube = std::array<HaarFace<Value>, faceCount>;

/// The three coefficients of a square of `level` whose quarters have the means a b / c d:
/// 2^{-l}/4 · (a − b + c − d, a + b − c − d, a − b − c + d).
template <typename Value, typename Real>
constexpr std::array<Value, 3> squareCoefficients(int level, Value a, Value b, Value c, Value d) {
  const Real scale = Real(0.25) / Real(squaresPerSide(level));
  return {((a - b) + (c - d)) * scale, ((a + b) - (c + d)) * scale, ((a - b) - (c - d)) * scale};
}

/// Transforms the 32×32 texels of a face (row by row). `Real` is Value's number type.
template <typename Value, typename Real>
HaarFace<Value> haarForward(std::span<const Value> texels) {
  HaarFace<Value> face;
  std::span<const Value> finer = texels;
  for (int level = haarLevels - 1; level >= 0; --level) {
    const int side = squaresPerSide(level);
    for (int square = 0; square < side * side; ++square) {
      const auto [a, b, c, d] = children(level, square);
      const auto triple =
          squareCoefficients<Value, Real>(level, finer[a], finer[b], finer[c], finer[d]);
      for (int type = 0; type < 3; ++type)
        face.coefficients[coefficientIndex(level, square, type)] = triple[type];
      face.means[meanIndex(level, square)] =
          ((finer[a] + finer[b]) + (finer[c] + finer[d])) * Real(0.25);
    }
    finer = std::span(face.means).subspan(firstMean(level), side * side);
  }
  face.coefficients[0] = face.means[0];
  return face;
}

/// Texels (row by row) of a face given by its coefficients alone: Φ plus the signed wavelets.
template <typename Value, typename Real>
std::vector<Value> haarInverse(std::span<const Value> coefficients) {
  std::vector<Value> squares{coefficients[0]};
  for (int level = 0; level < haarLevels; ++level) {
    const Real height = Real(squaresPerSide(level));
    std::vector<Value> finer(4 * squares.size());
    for (int square = 0; square < int(squares.size()); ++square) {
      const auto quarter = children(level, square);
      for (int child = 0; child < 4; ++child) {
        Value value = squares[square];
        for (int type = 0; type < 3; ++type)
          value += coefficients[coefficientIndex(level, square, type)] *
                   (height * Real(waveletSign(type, child)));
        finer[quarter[child]] = value;
      }
    }
    squares = std::move(finer);
  }
  return squares;
}

/// Transforms a whole cube of texels in texel order.
template <typename Value, typename Real>
HaarCube<Value> haarForwardCube(std::span<const Value> texels) {
  HaarCube<Value> cube;
  for (int face = 0; face < faceCount; ++face)
    cube[face] = haarForward<Value, Real>(texels.subspan(face * texelsPerFace, texelsPerFace));
  return cube;
}

}  // namespace haarlight
