#include "visibility/exact_visibility.h"

#include <algorithm>
#include <cmath>

#include "visibility/sphere_bin.h"

namespace haarlight {

namespace {

/// A sphere seen from a sample: vector to its centre and d² cos²α.
struct Cap {
  glm::vec3 toCenter;
  float rim;
};

Cap capOf(const Sphere& sphere, const glm::vec3& position, const glm::vec3& normal) {
  const glm::vec3 d = sphere.center - position;
  const float distanceSquared = (d.x * d.x + d.y * d.y) + d.z * d.z;
  const float radiusSquared = sphere.radius * sphere.radius;
  const float height = (d.x * normal.x + d.y * normal.y) + d.z * normal.z;
  const float depth = std::fmin(height, 0.0f);
  const float limit = horizonFactor * depth * depth;
  return {d, std::fmax(std::fmax(distanceSquared - radiusSquared, 0.0f), limit)};
}

/// Components of a vector along a face's direction and its s and t axes: c·D = major + s·S + t·T.
struct FaceComponents {
  float major, s, t;
};

FaceComponents onFace(int face, const glm::vec3& d) {
  switch (face) {
    case 0:
      return {d.x, -d.z, -d.y};
    case 1:
      return {-d.x, d.z, -d.y};
    case 2:
      return {d.y, d.x, d.z};
    case 3:
      return {-d.y, d.x, -d.z};
    case 4:
      return {d.z, d.x, -d.y};
    default:
      return {-d.z, -d.x, -d.y};
  }
}

/// Coordinate of the centre of a row or column, exact.
float centerCoordinate(int index) {
  return float(2 * index + 1 - faceSize) * 0.03125f;
}

/// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
/// so that no texel is lost.
constexpr float caution = 1.00001f;

/// Whether the cap does not reach the face's rows (or, with alongT and alongS exchanged, its
/// columns). By Cauchy's inequality (c·D)²/|c|² ≤ (major + t alongT)²/(1 + t²) + alongS², which is
/// largest at t = 1 when the sphere's centre is beyond the face's edge.
bool isBeyondEdge(float major, float alongT, float alongS, float rim) {
  const float atEdge = std::fmax(major + std::fabs(alongT), 0.0f);
  const float bound = 0.5f * (atEdge * atEdge) + alongS * alongS;
  return std::fabs(alongT) > major && bound * caution < rim;
}

/// One row of a face: c·D = atCenter + s · alongS, |c|² = lengthSquared + s².
struct Row {
  float atCenter, alongS, lengthSquared, rim;

  bool blocked(int column) const {
    const float s = centerCoordinate(column);
    const float dot = atCenter + s * alongS;
    return dot >= 0 && dot * dot >= (lengthSquared + s * s) * rim;
  }

  /// By Cauchy's inequality (c·D)² ≤ (atCenter²/lengthSquared + alongS²) |c|².
  bool mayBeBlocked() const {
    const float ahead = std::fmax(atCenter, 0.0f);
    const float bound = ahead * ahead + alongS * alongS * lengthSquared;
    return bound * caution >= lengthSquared * rim;
  }

  /// Column of the place where the angle to the sphere's centre is least: the largest one whose
  /// left border, (column − 16)/16, is not beyond alongS · lengthSquared / atCenter.
  int nearestColumn() const {
    if (atCenter <= 0) return alongS > 0 ? faceSize - 1 : 0;
    const float place = alongS * lengthSquared;
    int column = 0;
    for (int step = 16; step > 0; step /= 2)
      if (place >= float(column + step - 16) * 0.0625f * atCenter) column += step;
    return column;
  }

  /// A blocked column, if there is one; else any.
  int blockedColumn() const {
    const int nearest = nearestColumn();
    if (blocked(nearest)) return nearest;
    const int left = std::max(nearest - 1, 0);
    return blocked(left) ? left : std::min(nearest + 1, faceSize - 1);
  }

  std::uint32_t bits() const {
    const int inside = blockedColumn();
    if (!blocked(inside)) return 0;
    int first = inside, last = inside;
    for (int step = 16; step > 0; step /= 2) {
      if (first >= step && blocked(first - step)) first -= step;
      if (last + step < faceSize && blocked(last + step)) last += step;
    }
    return ~0u << first & ~0u >> (faceSize - 1 - last);
  }
};

std::uint32_t rowBits(const FaceComponents& d, float t, float rim) {
  const Row row{d.major + t * d.t, d.s, 1 + t * t, rim};
  return row.mayBeBlocked() ? row.bits() : 0;
}

}  // namespace

void addSphereExactly(BitCube& cube, const Sphere& sphere, const glm::vec3& samplePosition,
                      const glm::vec3& sampleNormal) {
  const Cap cap = capOf(sphere, samplePosition, sampleNormal);
  for (int face = 0; face < faceCount; ++face) {
    const FaceComponents d = onFace(face, cap.toCenter);
    if (isBeyondEdge(d.major, d.t, d.s, cap.rim) || isBeyondEdge(d.major, d.s, d.t, cap.rim))
      continue;
    for (int row = 0; row < faceSize; ++row)
      cube.rows[face * faceSize + row] |= rowBits(d, centerCoordinate(row), cap.rim);
  }
}

BitCube exactBitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition,
                     const glm::vec3& sampleNormal) {
  BitCube cube;
  for (const Sphere& sphere : spheres) addSphereExactly(cube, sphere, samplePosition, sampleNormal);
  return cube;
}

}  // namespace haarlight
