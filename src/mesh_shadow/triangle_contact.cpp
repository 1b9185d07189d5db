#include "mesh_shadow/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace haarlight {

namespace {

/// A triangle of a pair, from a place next to both.
struct Side {
  std::array<glm::dvec3, 3> corners{};
  std::array<bool, 3> isShared{};

  Side(const NumberedTriangle& own, const NumberedTriangle& other, const glm::dvec3& origin) {
    for (int i = 0; i < 3; ++i) {
      corners[i] = own.corners[i] - origin;
      isShared[i] = std::ranges::find(other.numbers, own.numbers[i]) != other.numbers.end();
    }
  }

  int sharedCount() const { return isShared[0] + isShared[1] + isShared[2]; }
  glm::dvec3 edge(int i) const { return corners[(i + 1) % 3] - corners[i]; }
  glm::dvec3 normal() const { return glm::cross(edge(0), edge(1)); }

  /// Whether all corners that the other triangle has not lie further along a direction.
  bool isBeyond(const glm::dvec3& direction, double place) const {
    for (int i = 0; i < 3; ++i)
      if (!isShared[i] && !(glm::dot(direction, corners[i]) > place)) return false;
    return true;
  }
};

/// What rounding may do to a product of three or four differences of coordinates.
struct Rounding {
  double ofThree, ofFour;

  explicit Rounding(double size) : ofThree(1e-14 * size * size * size), ofFour(ofThree * size) {}
};

/// By the plane of the one, which has no more of the other than what they share.
bool isSeparatedByPlane(const Side& one, const Side& other, const Rounding& rounding) {
  const glm::dvec3 normal = one.normal();
  const double place = glm::dot(normal, one.corners[0]), least = rounding.ofThree;
  return other.isBeyond(normal, place + least) || other.isBeyond(-normal, least - place);
}

/// By a plane through an edge of the one and across it, if they share nothing besides that edge.
bool isSeparatedAtEdge(const Side& one, const Side& other, const Rounding& rounding) {
  const glm::dvec3 normal = one.normal();
  for (int i = 0; i < 3; ++i) {
    if (one.isShared[(i + 2) % 3]) continue;
    const glm::dvec3 outwards = glm::cross(one.edge(i), normal);
    const double place = glm::dot(outwards, one.corners[i]);
    if (other.isBeyond(outwards, place + rounding.ofFour)) return true;
  }
  return false;
}

struct Interval {
  double low, high;
};

Interval alongDirection(const Side& side, const glm::dvec3& direction) {
  const auto [low, high] =
      std::minmax({glm::dot(direction, side.corners[0]), glm::dot(direction, side.corners[1]),
                   glm::dot(direction, side.corners[2])});
  return {low, high};
}

/// By a plane that is parallel to an edge of each. If they share a corner, it lies in both edges,
/// and the third corners lie on different sides.
bool isSeparatedByEdges(const Side& one, const Side& other, const Rounding& rounding) {
  const bool isAtCorner = one.sharedCount() == 1;
  const double least = rounding.ofThree;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 normal = glm::cross(one.edge(i), other.edge(k));
      if (isAtCorner) {
        const int third = (i + 2) % 3, otherThird = (k + 2) % 3;
        if (one.isShared[third] || other.isShared[otherThird]) continue;
        const double place = glm::dot(normal, one.corners[i]);
        const double a = glm::dot(normal, one.corners[third]) - place;
        const double b = glm::dot(normal, other.corners[otherThird]) - place;
        if (std::min(a, b) < -least && std::max(a, b) > least) return true;
        continue;
      }
      const Interval a = alongDirection(one, normal), b = alongDirection(other, normal);
      if (a.high + least < b.low || b.high + least < a.low) return true;
    }
  return false;
}

/// Which corners two triangles share: how many, and the last of them in each.
struct SharedCorners {
  int count = 0, inA = 0, inB = 0;

  SharedCorners(const VertexTriple& a, const VertexTriple& b) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (a[i] == b[k]) ++count, inA = i, inB = k;
  }
};

/// By a plane through the only corner that they share, on whose sides their other corners lie: one
/// across the way from the middle of these of the one to that of the other. Most triangles around
/// a corner are told by this.
bool areSeparatedAtCorner(const TriangleCorners& a, const TriangleCorners& b,
                          const SharedCorners& shared) {
  const glm::dvec3 corner = a[shared.inA];
  const glm::dvec3 a1 = a[(shared.inA + 1) % 3] - corner, a2 = a[(shared.inA + 2) % 3] - corner;
  const glm::dvec3 b1 = b[(shared.inB + 1) % 3] - corner, b2 = b[(shared.inB + 2) % 3] - corner;
  const glm::dvec3 across = a1 + a2 - b1 - b2;
  const double squares = glm::dot(a1, a1) + glm::dot(a2, a2) + glm::dot(b1, b1) + glm::dot(b2, b2);
  const double least = 1e-14 * squares;
  return std::min(glm::dot(across, a1), glm::dot(across, a2)) > least &&
         std::max(glm::dot(across, b1), glm::dot(across, b2)) < -least;
}

}  // namespace

bool mayTouchElsewhere(const NumberedTriangle& a, const NumberedTriangle& b) {
  const SharedCorners shared(a.numbers, b.numbers);
  if (shared.count == 3) return true;
  if (shared.count == 1 && areSeparatedAtCorner(a.corners, b.corners, shared)) return false;
  const glm::dvec3 origin = a.corners[shared.inA];
  const Side one(a, b, origin), other(b, a, origin);
  double squared = 0;
  for (const Side* side : {&one, &other})
    for (const glm::dvec3& corner : side->corners)
      squared = std::max(squared, glm::dot(corner, corner));
  const Rounding rounding(2 * std::sqrt(squared));  // differences are at most twice as large
  return !isSeparatedByPlane(one, other, rounding) && !isSeparatedByPlane(other, one, rounding) &&
         !isSeparatedAtEdge(one, other, rounding) && !isSeparatedAtEdge(other, one, rounding) &&
         (shared.count == 2 || !isSeparatedByEdges(one, other, rounding));
}

}  // namespace haarlight
