#pragma once

/// The triple product as weights of squares.
///
/// With light and lobe given, the triple product is linear in the occlusion O, and every term of it
/// reads O on one square of the Haar pyramid. So all terms of a square are one row of weights, per
/// channel:
///
///     w_h (a − b + c − d) + w_v (a + b − c − d) + w_d (a − b − c + d) + w_n (a + b + c + d)
///
/// with the numbers of blocked texels a b / c d in the square's quarters. The weights are rounded
/// to integers, each lobe and channel with its own power of two, and everything is added modulo
/// 2³². So sums are exact, the order of their terms does not matter, and the sum over squares
/// equals the sum over blocked texels of the weights that spreadOverTexels() gives, bit by bit
/// (docs/numerics.md).

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/light_selection.h"

namespace haarlight {

/// A square of the Haar pyramid (haar/basis.h).
struct Square {
  int face;
  int level;
  int square;
};

/// Lists of squares by how their occlusion is looked up: levels 0 … 2, level 3, level 4.
enum SquareDetail { coarseSquares = 0, blockSquares = 1, quarterSquares = 2 };
inline constexpr int squareDetails = 3;

/// Coarse squares are all there, in the order face · 21 + mean index; this many in all.
inline constexpr int coarseSquareCount = faceCount * coarseMeansPerFace;

/// The squares that terms read, in the order of a lobe's weights.
class SquareList {
 public:
  /// All coarse squares, and the finer ones of `terms` that `settings` has occlusion for; every
  /// square when the settings keep everything.
  SquareList(std::span<const LightTerm> terms, const ShadingSettings& settings);

  /// Entries, with fillers; a multiple of 32.
  std::size_t size() const { return squares_.size(); }
  /// End of each list; each is filled up with squares of level −1 to a multiple of 32.
  const std::array<std::uint32_t, squareDetails>& ends() const { return ends_; }
  const Square& operator[](std::size_t index) const { return squares_[index]; }
  static bool isFiller(const Square& square) { return square.level < 0; }

  static constexpr int absent = -1;
  /// Index of a square, or `absent`.
  int indexOf(const Square& square) const {
    return indices_[square.face * meansPerFace + meanIndex(square.level, square.square)];
  }

 private:
  void append(SquareDetail detail);

  std::vector<bool> wanted_ = std::vector<bool>(faceCount * meansPerFace);
  std::vector<Square> squares_;
  std::array<std::uint32_t, squareDetails> ends_{};
  std::vector<int> indices_ = std::vector<int>(faceCount * meansPerFace, absent);
};

/// Weights of a square: [channel], x y z w = horizontal, vertical, diagonal, number.
template <typename Vec4>
using ChannelWeights = std::array<Vec4, 3>;
using ExactSquareWeights = std::vector<ChannelWeights<glm::dvec4>>;
using SquareWeights = std::vector<ChannelWeights<glm::uvec4>>;

/// The terms of one lobe (method.md §5) gathered by squares, in order of `squares`:
///
///   light terms   L_M (O_M psum(p) + p_M psum(O) + 2^l (p_a O_b + p_b O_a)) for the wavelets M of
///                 `terms`, a and b the other types on the square; L_Φ p_Φ O_Φ
///   lobe terms    p_M O_M psum(L) for the lobe's wavelets of levels 0 … 2, or all of them
ExactSquareWeights gatherBySquares(const SquareList& squares, const ShadingSettings& settings,
                                   const LightHaar& light, std::span<const LightTerm> terms,
                                   const HaarCube<float>& lobe);

/// Weight of every texel, in texel order: the sum over the squares it lies in of ± w_h ± w_v ± w_d
/// + w_n. `Vec3` holds the channels of `weights`.
template <typename Vec3, typename Vec4>
std::vector<Vec3> spreadOverTexels(const SquareList& squares,
                                   std::span<const ChannelWeights<Vec4>> weights);

/// Numbers that the weights of all texels take for one lobe: texels times channels.
inline constexpr int texelWeightCount = 3 * texelCount;

/// Weights and unshadowed radiance of one lobe as integers; value = integer · scale.
struct RoundedLobe {
  SquareWeights weights;
  /// RGB, 0; two's complement.
  glm::uvec4 unshadowed{0};
  /// RGB, 0; powers of two.
  glm::vec4 scale{1, 1, 1, 0};
};

/// Rounds so that unshadowed less any sum of weights of texels lies within 31 bits and a sign. What
/// rounding takes from a square is given to the squares in its quarters, so that large squares do
/// not carry large errors.
RoundedLobe roundWeights(const SquareList& squares, const ExactSquareWeights& weights,
                         const glm::dvec3& unshadowed);

}  // namespace haarlight
