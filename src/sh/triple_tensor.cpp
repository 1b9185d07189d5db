#include "sh/triple_tensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <numbers>

#include "sh/quadrature.h"

namespace haarlight {

namespace {

/// ∫ T_a T_b T_c dφ with T_m = √2 cos mφ, 1, √2 sin |m|φ for m > 0, m = 0, m < 0.
double azimuthIntegral(int a, int b, int c) {
  std::array<int, 3> m{a, b, c};
  std::ranges::sort(m, {}, [](int value) { return std::abs(value); });
  const auto [small, middle, large] = m;
  if ((small < 0) != ((middle < 0) != (large < 0))) return 0;  // an odd number of sines
  if (std::abs(small) + std::abs(middle) != std::abs(large)) return 0;
  const double pi = std::numbers::pi;
  if (small == 0) return 2 * pi;
  return pi * (large > 0 && small < 0 ? -std::numbers::sqrt2 : std::numbers::sqrt2);
}

/// A few coefficients are 0 without a rule that says so; true values are far above this.
constexpr double roundingError = 1e-12;

/// Values of the functions' factors in z at the points of a Gauss–Legendre rule.
class PolarFactors {
 public:
  explicit PolarFactors(int order) : rule_(gaussLegendre((3 * (order - 1)) / 2 + 1)) {
    // At φ = 0 the functions with m > 0 are √2 times their factor in z, those with m < 0 vanish.
    for (const double z : rule_.nodes) {
      ShVector<double> basis(order);
      evaluateShBasis<double>(order, {std::sqrt((1 - z) * (1 + z)), 0, z}, basis.coefficients());
      values_.push_back(std::move(basis));
    }
  }

  struct Function {
    int l, m;
  };

  double integral(const Function& a, const Function& b, const Function& c) const {
    double sum = 0;
    for (std::size_t point = 0; point < values_.size(); ++point)
      sum += rule_.weights[point] * at(point, a) * at(point, b) * at(point, c);
    return sum;
  }

 private:
  double at(std::size_t point, const Function& f) const {
    const double value = values_[point].at(f.l, std::abs(f.m));
    return f.m == 0 ? value : value / std::numbers::sqrt2;
  }

  GaussLegendreRule rule_;
  std::vector<ShVector<double>> values_;
};

/// The m of up to two functions, one with a cosine and one with a sine, that fit those of two
/// others.
void fittingOrders(int a, int b, std::vector<int>& fitting) {
  fitting.clear();
  const bool sine = (a < 0) != (b < 0);
  for (const int size : {std::abs(std::abs(a) - std::abs(b)), std::abs(a) + std::abs(b)})
    if (!sine || size > 0) fitting.push_back(sine ? -size : size);
  std::ranges::sort(fitting);
  fitting.erase(std::ranges::unique(fitting).begin(), fitting.end());
}

}  // namespace

ShTripleTensor::ShTripleTensor(int order) : order_(order) {
  requireShOrder(order);
  const PolarFactors polar(order);
  std::vector<int> orders;
  for (int i = 0; i < shCoefficientCount(order); ++i)
    for (int j = i; j < shCoefficientCount(order); ++j) {
      const int l1 = shDegree(i), l2 = shDegree(j), m1 = i - shIndex(l1, 0),
                m2 = j - shIndex(l2, 0);
      fittingOrders(m1, m2, orders);
      for (int l3 = l2 + (l1 % 2); l3 <= std::min(l1 + l2, order - 1); l3 += 2)
        for (const int m3 : orders) {
          const int k = shIndex(l3, m3);
          if (std::abs(m3) > l3 || k < j) continue;
          const double value =
              azimuthIntegral(m1, m2, m3) * polar.integral({l1, m1}, {l2, m2}, {l3, m3});
          if (std::abs(value) > roundingError) entries_.push_back({i, j, k, value});
        }
    }
}

const ShTripleTensor& ShTripleTensor::shared(int order) {
  struct Slot {
    std::once_flag made;
    std::unique_ptr<const ShTripleTensor> tensor;
  };
  static std::array<Slot, maximumShOrder + 1> slots;
  requireShOrder(order);
  Slot& slot = slots[order];
  std::call_once(slot.made, [&] { slot.tensor = std::make_unique<ShTripleTensor>(order); });
  return *slot.tensor;
}

double ShTripleTensor::at(int i, int j, int k) const {
  std::array<int, 3> index{i, j, k};
  std::ranges::sort(index);
  const auto key = [](const Entry& entry) { return std::array{entry.i, entry.j, entry.k}; };
  const auto found = std::ranges::lower_bound(entries_, index, {}, key);
  return found != entries_.end() && key(*found) == index ? found->value : 0;
}

template <typename A, typename B>
ShVector<A> product(const ShVector<A>& f, const ShVector<B>& g) {
  f.requireOrder(g.order());
  using Number = ShNumberOf<A>;
  ShVector<A> result(f.order());
  for (const auto& [i, j, k, exact] : ShTripleTensor::shared(f.order()).entries()) {
    const Number value = Number(exact);
    const auto both = [&](int a, int b) { return f[a] * Number(g[b]) + f[b] * Number(g[a]); };
    if (i == j) {
      result[k] += value * (f[i] * Number(g[i]));
      if (j != k) result[i] += value * both(i, k);
      continue;
    }
    result[k] += value * both(i, j);
    result[i] += value * (j == k ? f[j] * Number(g[j]) : both(j, k));
    if (j != k) result[j] += value * both(i, k);
  }
  return result;
}

template ShVector<float> product(const ShVector<float>&, const ShVector<float>&);
template ShVector<double> product(const ShVector<double>&, const ShVector<double>&);
template ShVector<glm::vec3> product(const ShVector<glm::vec3>&, const ShVector<float>&);
template ShVector<glm::dvec3> product(const ShVector<glm::dvec3>&, const ShVector<double>&);

template <typename Real>
ShVector<Real> square(const ShVector<Real>& f) {
  ShVector<Real> result(f.order());
  for (const auto& [i, j, k, exact] : ShTripleTensor::shared(f.order()).entries()) {
    const Real value = Real(exact), twice = 2 * value;
    if (i == j) {
      result[k] += value * (f[i] * f[i]);
      if (j != k) result[i] += twice * (f[i] * f[k]);
      continue;
    }
    result[k] += twice * (f[i] * f[j]);
    result[i] += j == k ? value * (f[j] * f[j]) : twice * (f[j] * f[k]);
    if (j != k) result[j] += twice * (f[i] * f[k]);
  }
  return result;
}

template ShVector<float> square(const ShVector<float>&);
template ShVector<double> square(const ShVector<double>&);

double tripleIntegral(const ShVector<double>& f, const ShVector<double>& g,
                      const ShVector<double>& h) {
  return dot(product(f, g), h);
}

ShTransferMatrix::ShTransferMatrix(const ShVector<double>& b)
    : order_(b.order()), entries_(std::size_t(b.size()) * b.size()) {
  const int size = b.size();
  for (const auto& entry : ShTripleTensor::shared(order_).entries()) {
    std::array<int, 3> index{entry.i, entry.j, entry.k};
    do entries_[index[0] * size + index[1]] += entry.value * b[index[2]];
    while (std::ranges::next_permutation(index).found);
  }
}

template <typename Value>
ShVector<Value> ShTransferMatrix::operator()(const ShVector<Value>& f) const {
  f.requireOrder(order_);
  ShVector<Value> result(order_);
  for (int i = 0; i < f.size(); ++i)
    for (int j = 0; j < f.size(); ++j) result[i] += f[j] * ShNumberOf<Value>(at(i, j));
  return result;
}

template ShVector<float> ShTransferMatrix::operator()(const ShVector<float>&) const;
template ShVector<double> ShTransferMatrix::operator()(const ShVector<double>&) const;
template ShVector<glm::vec3> ShTransferMatrix::operator()(const ShVector<glm::vec3>&) const;
template ShVector<glm::dvec3> ShTransferMatrix::operator()(const ShVector<glm::dvec3>&) const;

}  // namespace haarlight
