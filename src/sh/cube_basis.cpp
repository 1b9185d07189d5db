#include "sh/cube_basis.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "base/parallel.h"
#include "sh/quadrature.h"

namespace haarlight {

namespace {

/// Points in s and in t of a texel. The integrand's singularities lie as far from the texel as
/// `side` of its half widths, so each point gains a factor of (2 side)²; but away from the real
/// axis degrees up to `order` first grow.
int pointsPerTexel(int order, int side) {
  const double gain = std::log(side + std::sqrt(double(side) * side + 1));
  return 2 + int(std::ceil((18 + 0.75 * order) / gain));
}

/// Numbers in double for the sums: double or glm::dvec3.
double widened(double value) {
  return value;
}
glm::dvec3 widened(const glm::dvec3& value) {
  return value;
}

}  // namespace

CubeBasis::CubeBasis(int order, int side) : order_(order), side_(side) {
  requireShOrder(order);
  if (side < 1) throw std::invalid_argument("a cube map's face has at least one texel");
  const std::size_t texels = std::size_t(faceCount) * side * side;
  integrals_.resize(texels * shCoefficientCount(order));
  parallelFor(texels, 16, [this](std::size_t begin, std::size_t end) {
    for (std::size_t texel = begin; texel < end; ++texel) integrateTexel(int(texel));
  });
}

void CubeBasis::integrateTexel(int texel) {
  const GaussLegendreRule rule = gaussLegendre(pointsPerTexel(order_, side_));
  const int face = texel / (side_ * side_);
  const int row = texel / side_ % side_, column = texel % side_;
  const auto coordinate = [this](int index, double node) {
    return (2 * index + 1 + node) / side_ - 1;
  };
  ShVector<double> basis(order_);
  double* integrals = integrals_.data() + std::size_t(texel) * basis.size();
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const glm::dvec3 place =
          cubeDirection({face, coordinate(column, rule.nodes[i]), coordinate(row, rule.nodes[k])});
      const double distance = glm::length(place);
      const double weight = rule.weights[i] * rule.weights[k] /
                            (side_ * double(side_) * distance * distance * distance);
      evaluateShBasis<double>(order_, place / distance, basis.coefficients());
      for (int n = 0; n < basis.size(); ++n) integrals[n] += weight * basis[n];
    }
}

const CubeBasis& CubeBasis::shared(int order, int side) {
  static std::mutex mutex;
  static std::map<std::pair<int, int>, std::unique_ptr<const CubeBasis>> tables;
  const std::lock_guard lock(mutex);
  auto& table = tables[{order, side}];
  if (!table) table = std::make_unique<CubeBasis>(order, side);
  return *table;
}

std::span<const double> CubeBasis::integrals(int texel) const {
  const std::size_t count = shCoefficientCount(order_);
  return std::span(integrals_).subspan(texel * count, count);
}

template <typename Value>
ShVector<Value> CubeBasis::project(std::span<const Value> texels) const {
  const int count = shCoefficientCount(order_);
  if (texels.size() * count != integrals_.size())
    throw std::invalid_argument("the cube map has another number of texels than the table");
  using Sum = decltype(widened(texels[0]));
  std::vector<Sum> sums(count, Sum(0));
  for (int texel = 0; texel < int(texels.size()); ++texel) {
    const Sum value(texels[texel]);
    const auto basis = integrals(texel);
    for (int i = 0; i < count; ++i) sums[i] += value * basis[i];
  }
  return {order_, std::vector<Value>(sums.begin(), sums.end())};
}

template ShVector<float> CubeBasis::project(std::span<const float>) const;
template ShVector<double> CubeBasis::project(std::span<const double>) const;
template ShVector<glm::vec3> CubeBasis::project(std::span<const glm::vec3>) const;
template ShVector<glm::dvec3> CubeBasis::project(std::span<const glm::dvec3>) const;

}  // namespace haarlight
