#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "sh/vector.h"

namespace haarlight::test {

inline glm::dvec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return glm::normalize(glm::dvec3(x, y, z));
}

/// Uniform over all rotations, as the matrix of a random unit quaternion.
inline glm::dmat3 randomRotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  double q[4], squares = 0;
  for (double& value : q) {
    value = normal(random);
    squares += value * value;
  }
  for (double& value : q) value /= std::sqrt(squares);
  const auto [w, x, y, z] = q;
  return {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
          2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
          2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
}

/// Coefficients between −1 and 1.
inline ShVector<double> randomFunction(int order, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  ShVector<double> f(order);
  for (double& coefficient : f.coefficients()) coefficient = value(random);
  return f;
}

/// Largest difference of coefficients.
inline double largestDifference(const ShVector<double>& f, const ShVector<double>& g) {
  f.requireOrder(g.order());
  double largest = 0;
  for (int i = 0; i < f.size(); ++i) largest = std::fmax(largest, std::abs(f[i] - g[i]));
  return largest;
}

}  // namespace haarlight::test
