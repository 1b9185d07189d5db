#pragma once

/// Coefficients of a function on the sphere in the basis of sh/basis.h.
///
/// A coefficient may be a number or a GLM vector: RGB is one ShVector<glm::vec3>, not three
/// vectors, as everywhere in haarlight (RadianceCube, HaarFace). Each basis value then serves all
/// channels at once, and scalar operands such as visibility or a lobe stay scalar:
/// dot(ShVector<glm::vec3>, ShVector<float>) is a colour.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "sh/basis.h"

namespace haarlight {

/// The number type of a coefficient: itself, or that of its components.
template <typename Value>
struct ShNumber {
  using Type = Value;
};
template <typename Real>
struct ShNumber<glm::vec<3, Real>> {
  using Type = Real;
};
template <typename Value>
using ShNumberOf = typename ShNumber<Value>::Type;

/// The order² coefficients of a function, in index order. `Value` is float, double, glm::vec3 or
/// glm::dvec3.
template <typename Value>
class ShVector {
 public:
  using Number = ShNumberOf<Value>;

  /// All coefficients 0. Throws std::invalid_argument for a wrong order.
  explicit ShVector(int order) : order_(order) {
    requireShOrder(order);
    coefficients_.resize(shCoefficientCount(order), Value(0));
  }

  /// Takes order² coefficients; throws std::invalid_argument for another number of them.
  ShVector(int order, std::vector<Value> coefficients)
      : order_(order), coefficients_(std::move(coefficients)) {
    requireShOrder(order);
    if (size() != shCoefficientCount(order))
      throw std::invalid_argument("a function of order n has n² coefficients");
  }

  int order() const { return order_; }
  int size() const { return int(coefficients_.size()); }

  Value& operator[](int index) { return coefficients_[index]; }
  const Value& operator[](int index) const { return coefficients_[index]; }
  Value& at(int l, int m) { return coefficients_[shIndex(l, m)]; }
  const Value& at(int l, int m) const { return coefficients_[shIndex(l, m)]; }

  /// Views of the coefficients; a function that is about to go gives none.
  std::span<Value> coefficients() & { return coefficients_; }
  std::span<const Value> coefficients() const& { return coefficients_; }
  std::span<const Value> coefficients() const&& = delete;

  /// The 2l + 1 coefficients of degree l, from m = −l on.
  std::span<Value> band(int l) & { return coefficients().subspan(l * l, 2 * l + 1); }
  std::span<const Value> band(int l) const& { return coefficients().subspan(l * l, 2 * l + 1); }
  std::span<const Value> band(int l) const&& = delete;

  /// The same function with fewer bands, or with bands of zeros added.
  ShVector withOrder(int order) const {
    ShVector result(order);
    std::copy_n(coefficients_.begin(), std::min(size(), result.size()),
                result.coefficients_.begin());
    return result;
  }

  /// Sums and differences need equal orders, else std::invalid_argument.
  ShVector& operator+=(const ShVector& other) {
    requireOrder(other.order_);
    for (int i = 0; i < size(); ++i) coefficients_[i] += other.coefficients_[i];
    return *this;
  }
  ShVector& operator-=(const ShVector& other) {
    requireOrder(other.order_);
    for (int i = 0; i < size(); ++i) coefficients_[i] -= other.coefficients_[i];
    return *this;
  }
  ShVector& operator*=(Number factor) {
    for (Value& coefficient : coefficients_) coefficient *= factor;
    return *this;
  }
  friend ShVector operator+(ShVector a, const ShVector& b) { return a += b; }
  friend ShVector operator-(ShVector a, const ShVector& b) { return a -= b; }
  friend ShVector operator*(ShVector a, Number factor) { return a *= factor; }
  friend ShVector operator*(Number factor, ShVector a) { return a *= factor; }

  bool operator==(const ShVector&) const = default;

  /// Throws std::invalid_argument unless this is a function of `order`.
  void requireOrder(int order) const {
    if (order != order_)
      throw std::invalid_argument("spherical harmonics of different orders do not go together");
  }

 private:
  int order_;
  std::vector<Value> coefficients_;
};

/// ∫ f g dω: a number, or a colour where one of the two is coloured.
template <typename A, typename B>
auto dot(const ShVector<A>& f, const ShVector<B>& g) {
  f.requireOrder(g.order());
  decltype(f[0] * g[0]) sum(0);
  for (int i = 0; i < f.size(); ++i) sum += f[i] * g[i];
  return sum;
}

/// The value of a function at a unit direction.
template <typename Value>
Value evaluate(const ShVector<Value>& f, const glm::vec<3, ShNumberOf<Value>>& direction) {
  using Number = ShNumberOf<Value>;
  ShVector<Number> basis(f.order());
  evaluateShBasis<Number>(f.order(), direction, basis.coefficients());
  return dot(f, basis);
}

/// Norm √(Σ_m |f_lm|²) of a band, over all channels. Rotations keep it.
template <typename Value>
ShNumberOf<Value> bandNorm(const ShVector<Value>& f, int l) {
  using Number = ShNumberOf<Value>;
  Number sum = 0;
  for (const Value& c : f.band(l)) {
    if constexpr (std::is_same_v<Value, Number>)
      sum += c * c;
    else
      sum += glm::dot(c, c);
  }
  return std::sqrt(sum);
}

/// The function with each band l multiplied by factors[l]: windows, convolution with a zonal
/// function. Throws std::invalid_argument unless there is a factor per band.
template <typename Value>
ShVector<Value> scaleBands(ShVector<Value> f, std::span<const double> factors) {
  f.requireOrder(int(factors.size()));
  for (int l = 0; l < f.order(); ++l)
    for (Value& c : f.band(l)) c *= ShNumberOf<Value>(factors[l]);
  return f;
}

}  // namespace haarlight
