#include "sh/rotation.h"

#include <cmath>
#include <cstdlib>
#include <glm/matrix.hpp>
#include <stdexcept>

namespace haarlight {

namespace {

/// The rotation nearest to R, by Newton's iteration for the polar decomposition; each step squares
/// the error.
glm::dmat3 nearestRotation(glm::dmat3 rotation) {
  const glm::dmat3 product = glm::transpose(rotation) * rotation;
  double error = std::abs(glm::determinant(rotation) - 1);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) error = std::fmax(error, std::abs(product[i][k] - (i == k)));
  if (!(error <= 1e-4)) throw std::invalid_argument("the matrix is not a rotation");
  for (int step = 0; step < 2; ++step)
    rotation = (rotation + glm::transpose(glm::inverse(rotation))) * 0.5;
  return rotation;
}

/// Matrix of one band, rows and columns −l … l. `at` reads it.
struct BandMatrix {
  int l;
  std::vector<double> entries = std::vector<double>((2 * l + 1) * (2 * l + 1));

  double& at(int row, int column) { return entries[(row + l) * (2 * l + 1) + column + l]; }
  double at(int row, int column) const { return entries[(row + l) * (2 * l + 1) + column + l]; }
};

/// Band 1 without the Condon–Shortley sign is (y, z, x).
BandMatrix firstBand(const glm::dmat3& rotation) {
  constexpr int axis[] = {1, 2, 0};
  BandMatrix band{1};
  for (int row = -1; row <= 1; ++row)
    for (int column = -1; column <= 1; ++column)
      band.at(row, column) = rotation[axis[column + 1]][axis[row + 1]];
  return band;
}

/// One band from the band before it; names as in the paper's Tables 1 and 2.
class NextBand {
 public:
  NextBand(const BandMatrix& first, const BandMatrix& before)
      : r_(first), before_(before), l_(before.l + 1) {}

  BandMatrix matrix() const {
    BandMatrix result{l_};
    for (int m = -l_; m <= l_; ++m)
      for (int n = -l_; n <= l_; ++n) result.at(m, n) = entry(m, n);
    return result;
  }

 private:
  double entry(int m, int n) const {
    const int size = std::abs(m);
    const double denominator = std::abs(n) == l_ ? 2 * l_ * (2 * l_ - 1) : (l_ + n) * (l_ - n);
    double sum = 0;
    if (size < l_) sum += std::sqrt((l_ + m) * (l_ - m) / denominator) * p(0, m, n);
    const double v = std::sqrt((l_ + size - 1) * (l_ + size) / denominator) / 2;
    sum += v * vTerm(m, n);
    if (m != 0 && size < l_ - 1)
      sum -= std::sqrt((l_ - size - 1) * (l_ - size) / denominator) / 2 * wTerm(m, n);
    return sum;
  }

  /// V, with the factors √(1 + δ) (1 − 2δ) of v for m = 0.
  double vTerm(int m, int n) const {
    if (m == 0) return -std::sqrt(2.0) * (p(1, 1, n) + p(-1, -1, n));
    if (m == 1) return std::sqrt(2.0) * p(1, 0, n);
    if (m == -1) return std::sqrt(2.0) * p(-1, 0, n);
    return m > 0 ? p(1, m - 1, n) - p(-1, -m + 1, n) : p(1, m + 1, n) + p(-1, -m - 1, n);
  }

  double wTerm(int m, int n) const {
    return m > 0 ? p(1, m + 1, n) + p(-1, -m - 1, n) : p(1, m - 1, n) - p(-1, -m + 1, n);
  }

  double p(int i, int m, int n) const {
    const int last = l_ - 1;
    if (n == l_) return r_.at(i, 1) * before_.at(m, last) - r_.at(i, -1) * before_.at(m, -last);
    if (n == -l_) return r_.at(i, 1) * before_.at(m, -last) + r_.at(i, -1) * before_.at(m, last);
    return r_.at(i, 0) * before_.at(m, n);
  }

  const BandMatrix& r_;
  const BandMatrix& before_;
  int l_;
};

}  // namespace

ShRotation::ShRotation(int order) : order_(order) {
  requireShOrder(order);
  entries_.resize(bandStart(order));
}

ShRotation::ShRotation(const glm::dmat3& rotation, int order) : ShRotation(order) {
  const BandMatrix first = firstBand(nearestRotation(rotation));
  entries_[0] = 1;
  BandMatrix current = first;
  for (int l = 1; l < order; ++l) {
    if (l > 1) current = NextBand(first, current).matrix();
    for (int row = -l; row <= l; ++row)
      for (int column = -l; column <= l; ++column) {
        const double sign = (row + column) % 2 ? -1 : 1;  // Condon–Shortley on both sides
        band(l)[place(l, row, column)] = sign * current.at(row, column);
      }
  }
}

template <typename Value>
ShVector<Value> ShRotation::operator()(const ShVector<Value>& f) const {
  if (f.order() > order_)
    throw std::invalid_argument("a rotation of order n turns functions of up to n bands");
  ShVector<Value> result(f.order());
  for (int l = 0; l < f.order(); ++l)
    for (int row = -l; row <= l; ++row)
      for (int column = -l; column <= l; ++column)
        result.at(l, row) += f.at(l, column) * ShNumberOf<Value>(at(l, row, column));
  return result;
}

template ShVector<float> ShRotation::operator()(const ShVector<float>&) const;
template ShVector<double> ShRotation::operator()(const ShVector<double>&) const;
template ShVector<glm::vec3> ShRotation::operator()(const ShVector<glm::vec3>&) const;
template ShVector<glm::dvec3> ShRotation::operator()(const ShVector<glm::dvec3>&) const;

ShRotation ShRotation::inverse() const {
  ShRotation result(order_);
  for (int l = 0; l < order_; ++l)
    for (int row = -l; row <= l; ++row)
      for (int column = -l; column <= l; ++column)
        result.band(l)[place(l, row, column)] = at(l, column, row);
  return result;
}

}  // namespace haarlight
