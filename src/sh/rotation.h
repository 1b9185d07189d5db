#pragma once

#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "sh/vector.h"

namespace haarlight {

/// A rotation of the sphere as a matrix on coefficients: block-diagonal, an orthogonal
/// (2l + 1) × (2l + 1) block per band. Computed once, applied to many functions.
///
/// The rotated function is g(R ω) = f(ω): what came from ω comes from R ω.
///
/// Recurrences of J. Ivanic and K. Ruedenberg, "Rotation Matrices for Real Spherical Harmonics"
/// (J. Phys. Chem. 100, 1996) with the corrections of 1998 (J. Phys. Chem. A 102, 9099), O(order³).
class ShRotation {
 public:
  /// R as GLM stores it (columns). It may be rounded to float: the nearest rotation is taken.
  /// Throws std::invalid_argument for a wrong order, and where R Rᵀ or det R differs from a
  /// rotation's by more than 1e-4.
  ShRotation(const glm::dmat3& rotation, int order);

  int order() const { return order_; }

  /// Entry of degree l that takes the coefficient of m = `column` to that of m = `row`.
  double at(int l, int row, int column) const { return band(l)[place(l, row, column)]; }

  /// f may have fewer bands than the rotation, else std::invalid_argument.
  template <typename Value>
  ShVector<Value> operator()(const ShVector<Value>& f) const;

  ShRotation inverse() const;

 private:
  explicit ShRotation(int order);

  std::span<double> band(int l) { return std::span(entries_).subspan(bandStart(l)); }
  std::span<const double> band(int l) const { return std::span(entries_).subspan(bandStart(l)); }
  static int bandStart(int l) { return l * (2 * l - 1) * (2 * l + 1) / 3; }
  static int place(int l, int row, int column) { return (row + l) * (2 * l + 1) + column + l; }

  int order_;
  std::vector<double> entries_;  ///< blocks one after the other, each row by row
};

}  // namespace haarlight
