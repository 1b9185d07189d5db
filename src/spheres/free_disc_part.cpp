#include "spheres/free_disc_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <vector>

namespace haarlight {

namespace {

struct Disc {
  glm::dvec2 center;
  double radius;
};

struct Interval {
  double begin, end;
};

/// Where the line at height y meets the disc; nowhere: an interval of length 0.
Interval chord(const Disc& disc, double y) {
  const double height = y - disc.center.y;
  const double half = std::sqrt(std::max(0.0, disc.radius * disc.radius - height * height));
  return {disc.center.x - half, disc.center.x + half};
}

double unionLength(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.begin < b.begin; });
  double length = 0, end = -std::numeric_limits<double>::infinity();
  for (const Interval& interval : intervals) {
    length += std::max(0.0, interval.end - std::max(interval.begin, end));
    end = std::max(end, interval.end);
  }
  return length;
}

/// Measures how much of a disc other discs leave free, from their chords along rows.
class RowScan {
 public:
  /// The part of the unit disc outside the discs, which lie in it.
  double freePart(std::span<const Disc> discs) {
    for (auto& row : chords_) row.clear();
    for (const Disc& disc : discs) add(disc);
    double whole = 0, covered = 0;
    for (int row = 0; row < rows; ++row) {
      const Interval full = chord({{}, 1}, height(row));
      whole += full.end - full.begin;
      covered += unionLength(chords_[row]);
    }
    return std::max(0.0, 1 - covered / whole);
  }

 private:
  static constexpr int rows = 32;

  static double height(double row) { return (2 * row + 1) / rows - 1; }
  static double rowAt(double height) { return ((height + 1) * rows - 1) / 2; }

  void add(const Disc& disc) {
    const int first = std::max(0, static_cast<int>(std::ceil(rowAt(disc.center.y - disc.radius))));
    const int last = static_cast<int>(std::floor(rowAt(disc.center.y + disc.radius)));
    for (int row = first; row <= std::min(last, rows - 1); ++row)
      chords_[row].push_back(chord(disc, height(row)));
  }

  std::array<std::vector<Interval>, rows> chords_;
};

}  // namespace

/// By parallel projection along a Fibonacci lattice over the half sphere: the other half sees the
/// same from behind.
double meanFreePart(const Ball& ball, std::span<const Sphere> spheres) {
  constexpr int directions = 32;
  std::vector<Disc> discs(spheres.size());
  RowScan scan;
  double sum = 0;
  for (int i = 0; i < directions; ++i) {
    const double z = (i + 0.5) / directions, flat = std::sqrt(1 - z * z);
    const double angle = 2 * std::numbers::pi * (i / std::numbers::phi);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const glm::dvec3 right(-sine, cosine, 0), up(z * cosine, z * sine, -flat);
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const glm::dvec3 offset = (glm::dvec3(spheres[k].center) - ball.center) / ball.radius;
      discs[k] = {{glm::dot(right, offset), glm::dot(up, offset)}, spheres[k].radius / ball.radius};
    }
    sum += scan.freePart(discs);
  }
  return sum / directions;
}

}  // namespace haarlight
