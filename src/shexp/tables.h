#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace haarlight {

/// Orders that spherical-harmonic exponentiation is offered for; arrays are sized for the largest.
inline constexpr int smallestShexpOrder = 2;
inline constexpr int largestShexpOrder = 6;
inline constexpr int largestShexpCount = largestShexpOrder * largestShexpOrder;

/// One product of a squaring: weight · g_first · g_second.
struct ShexpSquareTerm {
  std::uint16_t first, second;
  float weight;
};
static_assert(sizeof(ShexpSquareTerm) == 8);

/// The numbers that are no table.
struct ShexpConstants {
  /// Recurrence of the basis, the beginning of sh/legendre_recurrence.h: entry l(l + 1)/2 + m.
  std::array<float, largestShexpOrder> diagonal{};
  std::array<float, largestShexpOrder*(largestShexpOrder + 1) / 2> first{}, second{};
  /// Square of the norm up to which the exponential is taken for linear.
  float limitSquared = 0;
  /// Rows of `linear` per unit of the norm.
  float linearScale = 0;
};

/// All that spherical-harmonic exponentiation reads, in flat arrays and single precision, as every
/// engine reads it. Made in double.
struct ShexpTables {
  /// Rows of `logarithms`: cos α = row/128 for a sphere of angular radius α.
  static constexpr int logarithmRows = 128;
  /// Numbers of a row, a cache line: those of up to eight bands, then steps to the next row's.
  static constexpr int logarithmRowSize = 16;
  /// Rows of `linear` less one.
  static constexpr int linearRows = 16;

  /// Where not given: a norm of 1/8 and below needs no squaring. 1/4 saves one of some four
  /// squarings, and at order 6 costs half as much error again with a single sphere.
  static constexpr double defaultLinearLimit = 0.125;

  /// Throws std::invalid_argument for a wrong order, or a limit not above 0 or beyond the norm of
  /// the largest sphere's logarithm (about 6).
  explicit ShexpTables(int shOrder, double limit = defaultLinearLimit);

  /// The tables of an order with the default limit, made at the first call and kept; any thread may
  /// call.
  static const ShexpTables& shared(int shOrder);

  int order;
  /// row · 16 + l holds √(4π/(2l + 1)) f_l, the factor of y_lm in a sphere's rotated logarithm,
  /// and row · 16 + 8 + l how much more it is in the next row; 0 from l = order on.
  std::vector<float> logarithms;
  /// exp f ≈ a + b f for a function without mean of norm row/16 of the limit: (√4π a, b).
  std::vector<glm::vec2> linear;
  ShexpConstants constants;
  /// Coefficient k of a square is the sum of terms squareStarts[k] … squareStarts[k + 1] − 1, an
  /// even number of them: the last one may have no weight.
  std::vector<std::uint32_t> squareStarts;
  std::vector<ShexpSquareTerm> squareTerms;

  /// Halvings that bring the logarithm of so many spheres to the limit, wherever they are: no norm
  /// exceeds the sum of theirs.
  int mostHalvings(std::size_t spheres) const;

 private:
  void tabulateLogarithms();
  void tabulateLinear(double limit);
  void copyRecurrence();
  void tabulateSquare();

  /// Norm of the largest sphere's logarithm, in limits.
  double largestNorm_;
};

}  // namespace haarlight
