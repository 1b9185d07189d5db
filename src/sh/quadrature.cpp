#include "sh/quadrature.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace haarlight {

namespace {

constexpr double pi = std::numbers::pi;

void requirePoints(int count) {
  if (count < 1) throw std::invalid_argument("a quadrature rule needs at least one point");
}

struct LegendreValue {
  double value, derivative;
};

LegendreValue legendre(int degree, double x) {
  double before = 0, value = 1;
  for (int l = 1; l <= degree; ++l) {
    const double next = ((2 * l - 1) * x * value - (l - 1) * before) / l;
    before = value;
    value = next;
  }
  return {value, degree * (x * value - before) / (x * x - 1)};
}

/// A number in [0, 1) from 32 random bits: the same on every platform, which
/// std::uniform_real_distribution need not be.
double canonical(std::mt19937& random) {
  return random() * 0x1p-32;
}

glm::dvec3 cylindricalDirection(double z, double azimuth) {
  const double sine = std::sqrt((1 - z) * (1 + z));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), z};
}

}  // namespace

GaussLegendreRule gaussLegendre(int count) {
  requirePoints(count);
  GaussLegendreRule rule{std::vector<double>(count), std::vector<double>(count)};
  for (int i = 0; 2 * i < count; ++i) {
    double x = std::cos(pi * (i + 0.75) / (count + 0.5));
    if (2 * i + 1 == count) x = 0;
    // Newton's method doubles the digits of this estimate in each step.
    for (int step = 0; step < 6; ++step) {
      const LegendreValue at = legendre(count, x);
      x -= at.value / at.derivative;
    }
    const double slope = legendre(count, x).derivative;
    const int mirrored = count - 1 - i;
    rule.nodes[i] = -x;
    rule.nodes[mirrored] = x;
    rule.weights[i] = rule.weights[mirrored] = 2 / ((1 - x) * (1 + x) * slope * slope);
  }
  return rule;
}

SphereRule productRule(int polarCount, int azimuthCount) {
  requirePoints(azimuthCount);
  const GaussLegendreRule polar = gaussLegendre(polarCount);
  const double step = 2 * pi / azimuthCount;
  SphereRule rule;
  rule.reserve(std::size_t(polarCount) * azimuthCount);
  for (int i = 0; i < polarCount; ++i)
    for (int k = 0; k < azimuthCount; ++k)
      rule.push_back(
          {cylindricalDirection(polar.nodes[i], (k + 0.5) * step), polar.weights[i] * step});
  return rule;
}

SphereRule productRule(int degree) {
  return productRule(degree / 2 + 1, degree + 1);
}

SphereRule stratifiedSphere(int cellsPerSide, std::uint32_t seed) {
  requirePoints(cellsPerSide);
  std::mt19937 random(seed);
  const double cells = double(cellsPerSide) * cellsPerSide;
  SphereRule rule;
  rule.reserve(std::size_t(cells));
  for (int a = 0; a < cellsPerSide; ++a)
    for (int b = 0; b < cellsPerSide; ++b) {
      const double u = (a + canonical(random)) / cellsPerSide;
      const double v = (b + canonical(random)) / cellsPerSide;
      // cos(2 acos √(1 − u)) = 1 − 2u
      rule.push_back({cylindricalDirection(1 - 2 * u, 2 * pi * v), 4 * pi / cells});
    }
  return rule;
}

}  // namespace haarlight
