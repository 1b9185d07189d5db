#include "shexp/zonal_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sh/triple_tensor.h"
#include "sh/zonal.h"

namespace haarlight {

namespace {

const double constantOne = std::sqrt(4 * std::numbers::pi);  // the coefficient of the function 1

/// A symmetric matrix, diagonalised by Jacobi's rotations.
class Diagonalised {
 public:
  Diagonalised(int size, std::vector<double> matrix)
      : size_(size), matrix_(std::move(matrix)), vectors_(matrix_.size()) {
    for (int i = 0; i < size; ++i) vectors_[i * size + i] = 1;
    for (int sweep = 0; sweep < 30; ++sweep)
      for (int p = 0; p < size; ++p)
        for (int q = p + 1; q < size; ++q) rotate(p, q);
  }

  double eigenvalue(int k) const { return matrix_[k * size_ + k]; }
  double component(int k, int i) const { return vectors_[i * size_ + k]; }

 private:
  /// Turns rows and columns p and q so that their common entry vanishes.
  void rotate(int p, int q) {
    const double entry = matrix_[p * size_ + q];
    if (entry == 0) return;
    const double slope = (matrix_[q * size_ + q] - matrix_[p * size_ + p]) / (2 * entry);
    const double tangent = std::copysign(1 / (std::abs(slope) + std::hypot(slope, 1)), slope);
    const double cosine = 1 / std::hypot(tangent, 1), sine = tangent * cosine;
    const auto turn = [&](double& a, double& b) {
      const double before = a;
      a = cosine * before - sine * b;
      b = sine * before + cosine * b;
    };
    for (int i = 0; i < size_; ++i) {
      turn(matrix_[i * size_ + p], matrix_[i * size_ + q]);
      turn(vectors_[i * size_ + p], vectors_[i * size_ + q]);
    }
    for (int i = 0; i < size_; ++i) turn(matrix_[p * size_ + i], matrix_[q * size_ + i]);
  }

  int size_;
  std::vector<double> matrix_, vectors_;
};

/// Multiplication of zonal functions by a zonal function.
std::vector<double> zonalProductMatrix(std::span<const double> zonal) {
  const int order = int(zonal.size());
  const auto& tensor = ShTripleTensor::shared(order);
  std::vector<double> matrix(order * order);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j)
      for (int k = 0; k < order; ++k)
        matrix[i * order + j] += tensor.at(shIndex(i, 0), shIndex(j, 0), shIndex(k, 0)) * zonal[k];
  return matrix;
}

}  // namespace

std::vector<double> capVisibility(int order, double cosine) {
  auto visibility = projectZonal(
      order, [](double) { return -1.0; }, cosine, 1, order);
  visibility[0] += constantOne;
  return visibility;
}

std::vector<double> zonalFunction(std::span<const double> zonal,
                                  const std::function<double(double)>& function) {
  const int order = int(zonal.size());
  const Diagonalised diagonal(order, zonalProductMatrix(zonal));
  std::vector<double> result(order);
  for (int k = 0; k < order; ++k) {
    const double share = function(diagonal.eigenvalue(k)) * constantOne * diagonal.component(k, 0);
    for (int i = 0; i < order; ++i) result[i] += share * diagonal.component(k, i);
  }
  return result;
}

std::vector<double> zonalLogarithm(std::span<const double> visibility) {
  return zonalFunction(visibility, [](double eigenvalue) {
    return std::log(std::max(eigenvalue, smallestVisibility));
  });
}

ShVector<double> shExponential(const ShVector<double>& f) {
  // exp(M) 1 as exp(M/n) applied n times to the function 1; M = multiplication by f has a norm of
  // at most 2 Σ|f_i|, so that the series of M/n ends quickly.
  double bound = 0;
  for (const double coefficient : f.coefficients()) bound += std::abs(coefficient);
  const int steps = 1 + int(bound);
  const ShTransferMatrix multiply(f * (1.0 / steps));
  ShVector<double> result(f.order());
  result[0] = constantOne;
  for (int step = 0; step < steps; ++step) {
    ShVector<double> term = result;
    for (int power = 1; power < 30; ++power) {
      term = multiply(term) * (1.0 / power);
      result += term;
    }
  }
  return result;
}

}  // namespace haarlight
