#include "shadow/convex_gap.h"

#include <algorithm>
#include <limits>

namespace haarlight {

/// The weights with which the plane, line … through the points has its point next to the origin; no
/// numbers where the points do not span it.
std::array<double, 4> DifferenceSimplex::weightsOf(const std::array<Vertex, 4>& face,
                                                   int count) const {
  const glm::dvec3 a = face[0].difference;
  if (count == 1) return {1};
  const glm::dvec3 ab = face[1].difference - a;
  if (count == 2) {
    const double t = -glm::dot(a, ab) / glm::dot(ab, ab);
    return {1 - t, t};
  }
  const glm::dvec3 ac = face[2].difference - a, normal = glm::cross(ab, ac);
  if (count == 3) {
    const double squared = glm::dot(normal, normal);
    const double v = -glm::dot(glm::cross(a, ac), normal) / squared;
    const double w = -glm::dot(glm::cross(ab, a), normal) / squared;
    return {1 - v - w, v, w};
  }
  const glm::dvec3 ad = face[3].difference - a;
  const double volume = glm::dot(normal, ad);
  const double v = -glm::dot(glm::cross(ac, ad), a) / volume;
  const double w = -glm::dot(glm::cross(ad, ab), a) / volume;
  const double x = -glm::dot(normal, a) / volume;
  return {1 - v - w - x, v, w, x};
}

void DifferenceSimplex::add(const glm::dvec3& difference, const glm::dvec3& first) {
  const std::array<Vertex, 4> old = vertices_;
  const int oldCount = count_;
  double best = std::numeric_limits<double>::infinity();
  // The new nearest point lies within a face that has the new point as a corner.
  for (int others = 0; others < 1 << oldCount; ++others) {
    std::array<Vertex, 4> face{Vertex{difference, first}};
    int count = 1;
    for (int i = 0; i < oldCount && count < 4; ++i)
      if (others >> i & 1) face[count++] = old[i];
    const std::array<double, 4> weights = weightsOf(face, count);
    if (!std::all_of(weights.begin(), weights.begin() + count, [](double w) { return w >= 0; }))
      continue;
    glm::dvec3 point(0);
    for (int i = 0; i < count; ++i) point += weights[i] * face[i].difference;
    const double squared = glm::dot(point, point);
    if (!(squared < best)) continue;
    best = squared;
    vertices_ = face, weights_ = weights, count_ = count;
  }
}

glm::dvec3 DifferenceSimplex::nearest() const {
  glm::dvec3 result(0);
  for (int i = 0; i < count_; ++i) result += weights_[i] * vertices_[i].difference;
  return result;
}

glm::dvec3 DifferenceSimplex::nearestOfFirst() const {
  glm::dvec3 result(0);
  for (int i = 0; i < count_; ++i) result += weights_[i] * vertices_[i].first;
  return result;
}

}  // namespace haarlight
