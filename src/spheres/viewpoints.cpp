#include "spheres/viewpoints.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "mesh/random.h"

namespace haarlight {

namespace {

constexpr double goldenFraction = 1 / std::numbers::phi;

double fraction(double value) {
  return value - std::floor(value);
}

}  // namespace

glm::dmat3 basisAround(const glm::dvec3& z) {
  const double sign = std::copysign(1.0, z.z), a = -1 / (sign + z.z), b = z.x * z.y * a;
  return {{1 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

std::vector<glm::dvec3> directionsInCap(const glm::dvec3& axis, double cosine, std::size_t count,
                                        double turn) {
  const glm::dmat3 basis = basisAround(glm::normalize(axis));
  std::vector<glm::dvec3> directions;
  directions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (1 - cosine) * (double(i) + 0.5) / double(count);
    const double angle = 2 * std::numbers::pi * fraction(double(i) * goldenFraction + turn);
    const double flat = std::sqrt(std::max(0.0, 1 - z * z));
    directions.push_back(basis * glm::dvec3(flat * std::cos(angle), flat * std::sin(angle), z));
  }
  return directions;
}

std::vector<glm::dvec3> viewpointsAround(const BoundingBox& box, std::size_t count,
                                         std::uint64_t seed, const ViewpointRange& range) {
  const glm::dvec3 lower = box.lower, upper = box.upper, center = (lower + upper) / 2.0;
  const double half = glm::distance(lower, upper) / 2;
  Random random(seed);
  const double z = 2 * random.uniform() - 1, angle = 2 * std::numbers::pi * random.uniform();
  const double flat = std::sqrt(1 - z * z), turn = random.uniform(), start = random.uniform();
  std::vector<glm::dvec3> viewpoints =
      directionsInCap({flat * std::cos(angle), flat * std::sin(angle), z}, -1, count, turn);
  for (std::size_t i = 0; i < count; ++i) {
    // A second irrational step, or distance and angle would rise together.
    const double part = fraction(start + double(i) * std::numbers::sqrt2);
    const double distance = range.nearest + part * (range.farthest - range.nearest);
    viewpoints[i] = center + viewpoints[i] * (distance * half);
  }
  return viewpoints;
}

}  // namespace haarlight
