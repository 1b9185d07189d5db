#include "spheres/enclosing_ball.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <utility>
#include <vector>

#include "mesh/random.h"

namespace haarlight {

namespace {

/// Up to four points on the boundary of the ball.
struct Support {
  glm::dvec3 points[4];
  int count = 0;
};

bool contains(const Ball& ball, const glm::dvec3& point) {
  const glm::dvec3 d = point - ball.center;
  return glm::dot(d, d) <= ball.radius * ball.radius * (1 + 1e-12);
}

/// The smallest ball with all support points on its boundary: its centre is p0 + Σ λj (pj - p0)
/// with Gram matrix · λ = diagonal / 2. Points that do not span their space give nothing.
bool ballThrough(const Support& support, Ball& ball) {
  if (support.count == 0) return false;
  const glm::dvec3 origin = support.points[0];
  glm::dvec3 edges[3];
  glm::dmat3 gram(1);
  glm::dvec3 half(0);
  double scale = 1;
  for (int i = 1; i < support.count; ++i) edges[i - 1] = support.points[i] - origin;
  for (int i = 0; i + 1 < support.count; ++i) {
    for (int j = 0; j + 1 < support.count; ++j) gram[i][j] = glm::dot(edges[i], edges[j]);
    half[i] = gram[i][i] / 2;
    scale *= gram[i][i];
  }
  const double determinant = glm::determinant(gram);
  if (!(determinant > 1e-14 * scale)) return false;
  const glm::dvec3 weights = glm::inverse(gram) * half;
  glm::dvec3 offset(0);
  for (int i = 0; i + 1 < support.count; ++i) offset += weights[i] * edges[i];
  ball = {origin + offset, glm::length(offset)};
  return true;
}

/// The smallest ball around the first `count` points with all of `support` on its boundary.
Ball solve(std::span<const glm::vec3> points, std::size_t count, const Support& support,
           const Ball& start) {
  Ball ball = start;
  if (!ballThrough(support, ball) && support.count > 0) return start;
  if (support.count == 4) return ball;
  for (std::size_t i = 0; i < count; ++i) {
    if (contains(ball, points[i])) continue;
    Support more = support;
    more.points[more.count++] = points[i];
    ball = solve(points, i, more, ball);
  }
  return ball;
}

}  // namespace

Ball minimumEnclosingBall(std::span<const glm::vec3> points) {
  if (points.empty()) return {};
  std::vector<glm::vec3> shuffled(points.begin(), points.end());
  Random random(0);  // a random order makes the expected time linear
  for (std::size_t i = shuffled.size(); i > 1; --i)
    std::swap(shuffled[i - 1], shuffled[random.next() % i]);
  return solve(shuffled, shuffled.size(), {}, {shuffled[0], 0});
}

}  // namespace haarlight
