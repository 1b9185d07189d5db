#include "shexp/tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sh/legendre_recurrence.h"
#include "sh/triple_tensor.h"
#include "sh/zonal.h"
#include "shexp/zonal_functions.h"

namespace haarlight {

namespace {

constexpr double pi = std::numbers::pi;

/// A zonal function without mean, and its norm.
struct MeanFree {
  std::vector<double> zonal;
  double norm;
};

/// The logarithm of a sphere's visibility without its mean. Its norm grows with the sphere.
MeanFree meanFreeLogarithm(int order, double cosine) {
  MeanFree f{zonalLogarithm(capVisibility(order, cosine)), 0};
  f.zonal[0] = 0;
  double squares = 0;
  for (const double coefficient : f.zonal) squares += coefficient * coefficient;
  f.norm = std::sqrt(squares);
  return f;
}

/// The logarithm of a sphere that has a norm, by bisection over its angular radius.
MeanFree logarithmOfNorm(int order, double norm) {
  double smaller = 0, larger = pi / 2;
  for (int step = 0; step < 60; ++step) {
    const double middle = (smaller + larger) / 2;
    (meanFreeLogarithm(order, std::cos(middle)).norm < norm ? smaller : larger) = middle;
  }
  return meanFreeLogarithm(order, std::cos(larger));
}

}  // namespace

ShexpTables::ShexpTables(int shOrder, double limit) : order(shOrder) {
  if (order < smallestShexpOrder || order > largestShexpOrder)
    throw std::invalid_argument("spherical-harmonic exponentiation has an order of 2 to 6, not " +
                                std::to_string(order));
  const double largestNorm = meanFreeLogarithm(order, 0).norm;
  if (!(limit > 0 && limit <= largestNorm))
    throw std::invalid_argument(
        "the linear exponential needs a limit above 0 that a sphere reaches");
  largestNorm_ = largestNorm / limit;
  tabulateLogarithms();
  tabulateLinear(limit);
  copyRecurrence();
  tabulateSquare();
}

const ShexpTables& ShexpTables::shared(int shOrder) {
  static std::mutex mutex;
  static std::map<int, ShexpTables> kept;
  const std::lock_guard lock(mutex);
  return kept.try_emplace(shOrder, shOrder).first->second;
}

int ShexpTables::mostHalvings(std::size_t spheres) const {
  int halvings = 0;
  for (double norm = double(spheres) * largestNorm_; norm > 1; norm /= 2) ++halvings;
  return halvings;
}

void ShexpTables::tabulateLogarithms() {
  std::vector<std::vector<double>> factors;
  for (int row = 0; row <= logarithmRows; ++row)
    factors.push_back(
        convolutionFactors(zonalLogarithm(capVisibility(order, row / double(logarithmRows)))));
  logarithms.resize(logarithmRows * logarithmRowSize);
  for (int row = 0; row < logarithmRows; ++row)
    for (int l = 0; l < order; ++l) {
      float* own = &logarithms[row * logarithmRowSize + l];
      own[0] = float(factors[row][l]);
      own[logarithmRowSize / 2] = float(factors[row + 1][l]) - own[0];
    }
}

void ShexpTables::tabulateLinear(double limit) {
  constants.limitSquared = float(limit) * float(limit);
  constants.linearScale = float(linearRows / limit);
  // The a and b nearest to exp f in the least-squares sense; f and 1 are orthogonal. The one sphere
  // of a norm stands for whatever has this norm, as in the paper.
  linear.emplace_back(float(std::sqrt(4 * pi)), 1.0f);
  for (int row = 1; row <= linearRows; ++row) {
    const MeanFree f = logarithmOfNorm(order, row * double(float(limit)) / linearRows);
    const auto exact = zonalFunction(f.zonal, [](double x) { return std::exp(x); });
    double inner = 0;
    for (int l = 1; l < order; ++l) inner += exact[l] * f.zonal[l];
    linear.emplace_back(float(exact[0]), float(inner / (f.norm * f.norm)));
  }
}

void ShexpTables::copyRecurrence() {
  const auto& recurrence = legendreRecurrence<float>();
  const auto copy = [](const auto& from, auto& to) {
    std::copy_n(from.begin(), to.size(), to.begin());
  };
  copy(recurrence.diagonal, constants.diagonal);
  copy(recurrence.first, constants.first);
  copy(recurrence.second, constants.second);
}

void ShexpTables::tabulateSquare() {
  const auto& tensor = ShTripleTensor::shared(order);
  const int count = shCoefficientCount(order);
  squareStarts.push_back(0);
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < count; ++i)
      for (int j = i; j < count; ++j) {
        const double value = tensor.at(i, j, k);
        if (value == 0) continue;
        const float weight = float(i == j ? value : 2 * value);
        squareTerms.push_back({std::uint16_t(i), std::uint16_t(j), weight});
      }
    if (squareTerms.size() % 2 == 1) squareTerms.push_back({0, 0, 0});
    squareStarts.push_back(std::uint32_t(squareTerms.size()));
  }
}

}  // namespace haarlight
