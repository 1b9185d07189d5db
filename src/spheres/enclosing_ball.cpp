#include "spheres/enclosing_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haarlight {

namespace {

/// Up to four balls that touch the smallest ball around them from inside.
struct Support {
  Ball balls[4];
  int count = 0;
};

/// The smallest ball that all support balls touch from inside; radius NaN where there is none.
///
/// With the first ball's centre as origin, offsets d, and radii r as differences from the first's,
/// a centre z and a radius ρ satisfy d·z = (d² - r²) / 2 + ρ r for each further ball, so that
/// z = a + ρ b in the space of the offsets, and z² = ρ².
Ball tangentBall(const Support& support) {
  const Ball& first = support.balls[0];
  if (support.count == 1) return first;
  glm::dvec3 axes[3], a(0), b(0);
  for (int i = 0; i + 1 < support.count; ++i) {
    const glm::dvec3 d = support.balls[i + 1].center - first.center;
    const double r = support.balls[i + 1].radius - first.radius;
    glm::dvec3 rest = d;
    for (int j = 0; j < i; ++j) rest -= glm::dot(rest, axes[j]) * axes[j];
    const double height = glm::length(rest);
    axes[i] = rest / height;
    const double half = (glm::dot(d, d) - r * r) / 2;
    a += (half - glm::dot(d, a)) / height * axes[i];
    b += (r - glm::dot(d, b)) / height * axes[i];
  }
  const double p = 1 - glm::dot(b, b), q = glm::dot(a, b);
  const double root = std::sqrt(q * q + p * glm::dot(a, a));
  const double rho = q > 0 ? (q + root) / p : glm::dot(a, a) / (root - q);
  return {first.center + a + rho * b, first.radius + rho};
}

/// Replaces `support` by those of its balls and `further` that determine the smallest ball around
/// all of them, and returns that ball; radius infinite where rounding hides it.
Ball smallestBall(Support& support, const Ball& further) {
  Ball best{{}, std::numeric_limits<double>::infinity()};
  Support bestSupport;
  for (int chosen = 0; chosen < 1 << support.count; ++chosen) {
    Support candidate{{further}, 1};
    if (chosen == 15) continue;  // four balls determine every ball
    for (int i = 0; i < support.count; ++i)
      if (chosen >> i & 1) candidate.balls[candidate.count++] = support.balls[i];
    const Ball ball = tangentBall(candidate);
    const auto holds = [&](const Ball& inner) {
      return reach(inner, ball.center) <= ball.radius * (1 + 1e-10);
    };
    if (ball.radius < best.radius && holds(further) &&
        std::all_of(support.balls, support.balls + support.count, holds)) {
      best = ball;
      bestSupport = candidate;
    }
  }
  support = bestSupport;
  return best;
}

/// The ball that reaches farthest, seen from `center`, of items relative to `origin`.
template <typename Item>
Ball farthestBall(std::span<const Item> items, const glm::dvec3& origin, const glm::dvec3& center) {
  Ball farthest;
  double farthestReach = -1;
  for (const Item& item : items) {
    Ball ball = ballOf(item);
    ball.center -= origin;
    const double ballReach = reach(ball, center);
    if (ballReach <= farthestReach) continue;
    farthest = ball;
    farthestReach = ballReach;
  }
  return farthest;
}

template <typename Item>
Ball enclosingBall(std::span<const Item> items) {
  if (items.empty()) return {};
  Ball ball = ballOf(items[0]);
  const glm::dvec3 origin = ball.center;  // differences keep the digits of far-away sets
  ball.center = glm::dvec3(0);
  Support support{{ball}, 1};
  for (;;) {
    const Ball farthest = farthestBall(items, origin, ball.center);
    const double radius = reach(farthest, ball.center);
    if (radius > ball.radius * (1 + 1e-12)) {
      const Ball grown = smallestBall(support, farthest);
      if (grown.radius > ball.radius && std::isfinite(grown.radius)) {
        ball = grown;
        continue;
      }
    }
    return {origin + ball.center, radius};
  }
}

}  // namespace

Ball minimumEnclosingBall(std::span<const glm::vec3> points) {
  return enclosingBall(points);
}

Ball minimumEnclosingBall(std::span<const Sphere> spheres) {
  return enclosingBall(spheres);
}

}  // namespace haarlight
