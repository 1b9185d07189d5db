#include "sh/window.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace haarlight {

namespace {

double windowFactor(ShWindow window, double x) {
  if (x == 0) return 1;
  if (x >= 1) return 0;
  const double angle = std::numbers::pi * x;
  return window == ShWindow::hanning ? (1 + std::cos(angle)) / 2 : std::sin(angle) / angle;
}

}  // namespace

std::vector<double> windowFactors(ShWindow window, double width, int order) {
  requireShOrder(order);
  if (!(width > 0)) throw std::invalid_argument("a window's width is above 0");
  std::vector<double> factors(order);
  for (int l = 0; l < order; ++l) factors[l] = windowFactor(window, l / width);
  return factors;
}

}  // namespace haarlight
