#include "sh/zonal.h"

#include <cmath>
#include <numbers>

#include "sh/quadrature.h"

namespace haarlight {

namespace {
constexpr double pi = std::numbers::pi;
}

std::vector<double> projectZonal(int order, const std::function<double(double)>& g, double from,
                                 double to, int points) {
  requireShOrder(order);
  const GaussLegendreRule rule = gaussLegendre(points);
  std::vector<double> zonal(order), basis(order);
  const double half = (to - from) / 2;
  for (int i = 0; i < points; ++i) {
    const double z = from + (rule.nodes[i] + 1) * half;
    evaluateZonalBasis(z, basis);
    const double value = 2 * pi * half * rule.weights[i] * g(z);
    for (int l = 0; l < order; ++l) zonal[l] += value * basis[l];
  }
  return zonal;
}

ShVector<double> rotateZonal(std::span<const double> zonal, const glm::dvec3& axis) {
  ShVector<double> basis(int(zonal.size()));
  evaluateShBasis<double>(basis.order(), axis, basis.coefficients());
  return scaleBands(basis, convolutionFactors(zonal));
}

std::vector<double> clampedCosineZonal(int order) {
  requireShOrder(order);
  std::vector<double> zonal(order);
  double central = 1;  // l! / (2^l (l/2)!²) with alternating sign
  for (int l = 0; l < order; ++l) {
    const double norm = std::sqrt(pi * (2 * l + 1));  // 2π √((2l + 1)/4π)
    if (l == 1) zonal[l] = norm / 3;
    if (l % 2) continue;
    if (l > 0) central *= -(l - 1.0) / l;
    zonal[l] = -norm * central / ((l + 2.0) * (l - 1.0));
  }
  return zonal;
}

std::vector<double> convolutionFactors(std::span<const double> zonal) {
  std::vector<double> factors(zonal.size());
  for (std::size_t l = 0; l < zonal.size(); ++l)
    factors[l] = std::sqrt(4 * pi / (2.0 * l + 1)) * zonal[l];
  return factors;
}

}  // namespace haarlight
