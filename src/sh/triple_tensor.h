#pragma once

/// Products of functions on the sphere, by T_ijk = ∫ y_i y_j y_k dω.

#include <vector>

#include "sh/vector.h"

namespace haarlight {

/// The coefficients T_ijk of an order that differ from 0, each once (i ≤ j ≤ k): T does not change
/// when its indices are permuted. It is 0 unless l_i + l_j + l_k is even, no degree exceeds the sum
/// of the two others, and the m fit: about n⁵/14 entries of 24 bytes, 238 for order 5 and 230,571
/// for order 20.
///
/// In φ the integral of three sines and cosines is known; in z the product is a polynomial of
/// degree at most 3(n − 1), which Gauss–Legendre points integrate exactly. Sums of Clebsch–Gordan
/// coefficients would give the same numbers by way of alternating sums of factorials, which lose
/// digits as degrees grow.
class ShTripleTensor {
 public:
  /// T_ijk = value, i ≤ j ≤ k.
  struct Entry {
    int i, j, k;
    double value;
  };

  /// Throws std::invalid_argument for a wrong order.
  explicit ShTripleTensor(int order);

  /// The tensor of an order, made at the first call and kept; any thread may call.
  static const ShTripleTensor& shared(int order);

  int order() const { return order_; }

  /// Sorted by i, then j, then k.
  const std::vector<Entry>& entries() const { return entries_; }

  /// T_ijk for any indices below order².
  double at(int i, int j, int k) const;

 private:
  int order_;
  std::vector<Entry> entries_;
};

/// The product f g, projected to the order of the two: (f g)_k = Σ T_ijk f_i g_j. f may be
/// coloured. It holds the whole product when order ≥ order_f + order_g − 1 for the bands that are
/// not 0 (see ShVector::withOrder). Unequal orders: std::invalid_argument, also below.
template <typename A, typename B>
ShVector<A> product(const ShVector<A>& f, const ShVector<B>& g);

/// product(f, f) for a scalar f, by half the multiplications.
template <typename Real>
ShVector<Real> square(const ShVector<Real>& f);

/// ∫ f g h dω.
double tripleIntegral(const ShVector<double>& f, const ShVector<double>& g,
                      const ShVector<double>& h);

/// Multiplication by a fixed function b, M_ij = ∫ y_i y_j b dω: turns the coefficients of a light
/// into those of the light as b shadows it. Symmetric, order² × order².
class ShTransferMatrix {
 public:
  explicit ShTransferMatrix(const ShVector<double>& b);

  int order() const { return order_; }
  double at(int i, int j) const { return entries_[i * shCoefficientCount(order_) + j]; }

  /// M f, the same as product(f, b).
  template <typename Value>
  ShVector<Value> operator()(const ShVector<Value>& f) const;

 private:
  int order_;
  std::vector<double> entries_;  ///< row by row
};

}  // namespace haarlight
