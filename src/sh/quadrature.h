#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace haarlight {

/// Nodes in (−1, 1), ascending, and weights of a Gauss–Legendre rule.
struct GaussLegendreRule {
  std::vector<double> nodes, weights;
};

/// The rule of `count` ≥ 1 points, exact for polynomials of degree 2·count − 1 on [−1, 1]. Throws
/// std::invalid_argument for fewer points.
GaussLegendreRule gaussLegendre(int count);

/// A unit direction and the solid angle in steradians that it stands for.
struct WeightedDirection {
  glm::dvec3 direction;
  double weight;
};

/// Directions whose weights add up to 4π.
using SphereRule = std::vector<WeightedDirection>;

/// Product of Gauss–Legendre in z and equal steps in φ, from half a step on, z ascending. Exact for
/// polynomials in x, y, z of degree 2·polarCount − 1 and below azimuthCount.
SphereRule productRule(int polarCount, int azimuthCount);

/// The smallest product rule that is exact for polynomials of a degree ≥ 0. A product of k
/// functions of order n has degree k(n − 1).
SphereRule productRule(int degree);

/// N × N directions, one at random in each of N × N cells of equal solid angle; weights 4π/N². The
/// tutorial's samples: θ = 2 acos √(1 − u), φ = 2πv. The same seed gives the same directions
/// everywhere. Throws std::invalid_argument unless N ≥ 1.
SphereRule stratifiedSphere(int cellsPerSide, std::uint32_t seed);

}  // namespace haarlight
